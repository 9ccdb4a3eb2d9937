// From the library to the strip: see the header.
#include "app/window/style_strip_controller.h"

#include "app/styles/library.h"

namespace hairpaint::app {

namespace {

struct FoundStyles
{
    std::vector<model::PresetEntry> entries;
    QStringList problems;
};

} // namespace

StyleStripController::StyleStripController(view::StyleStrip& strip, StyleFiles& styles, Settings& settings, Jobs& jobs,
                                           model::Document& document)
    : QObject(&strip), m_strip(strip), m_settings(settings), m_jobs(jobs), m_pictures(jobs),
      m_cards(*strip.window(), jobs, this)
{
    connect(&strip, &view::StyleStrip::ordered, this, [this, &document](const QString& path, view::StyleOrder order) {
        if (order == view::StyleOrder::About)
            m_cards.open(path, styleName(path), *document.committed().head);
    });
    connect(&m_cards, &StyleCards::putOnWanted, &strip, &view::StyleStrip::choose);
    connect(&m_cards, &StyleCards::landmarksWanted, this, &StyleStripController::landmarksWanted);
    strip.setMarks(settings.styleMarks());
    connect(&styles, &StyleFiles::changed, this, &StyleStripController::refresh);
    connect(&styles, &StyleFiles::wanted, &strip, &view::StyleStrip::putOn);
    connect(&strip, &view::StyleStrip::saveStyleRequested, &styles, &StyleFiles::save);
    connect(&strip, &view::StyleStrip::ordered, &styles, &StyleFiles::carryOut);
    connect(&strip, &view::StyleStrip::undoWanted, &styles, &StyleFiles::undo);
    connect(&strip, &view::StyleStrip::marksChanged, this,
            [this](const view::StyleMarks& marks) { m_settings.setStyleMarks(marks); });
    connect(&styles, &StyleFiles::undoOffered, &strip, &view::StyleStrip::offerUndo);
    connect(&styles, &StyleFiles::renamed, this, [this](const QString& before, const QString& after) {
        view::StyleMarks marks = m_settings.styleMarks();
        marks.rename(before, after);
        m_settings.setStyleMarks(marks);
        m_strip.setMarks(marks);
    });
    connect(&strip, &view::StyleStrip::pictureWanted, &m_pictures, &StylePictures::make);
    connect(&m_pictures, &StylePictures::made, &strip, &view::StyleStrip::setPicture);
    connect(&strip, &view::StyleStrip::failed, this, &StyleStripController::failed);
}

void StyleStripController::refresh()
{
    m_jobs.start<FoundStyles>(
        tr("Reading the styles"),
        [](const model::Progress&) -> model::Result<FoundStyles> {
            FoundStyles list;
            list.entries = listStyles(&list.problems);
            return list;
        },
        this,
        [this, number = ++m_newest](const model::Result<FoundStyles>& list) {
            if (number != m_newest)
                return; // It was asked for again meanwhile.
            m_pictures.forget();
            if (list)
                m_strip.setEntries(list->entries);
            const QString problem = !list ? list.error().message : list->problems.value(0);
            if (!problem.isEmpty())
                Q_EMIT failed(problem);
        });
}

} // namespace hairpaint::app
