// From the library to the strip: see the header.
#include "app/window/style_strip_controller.h"

#include "app/styles/library.h"

namespace hairpaint::app {

namespace {

struct StyleList
{
    std::vector<model::PresetEntry> entries;
    QStringList problems;
};

} // namespace

StyleStripController::StyleStripController(view::StyleStrip& strip, StyleFiles& styles, Jobs& jobs)
    : QObject(&strip), m_strip(strip), m_jobs(jobs), m_pictures(jobs)
{
    connect(&styles, &StyleFiles::changed, this, &StyleStripController::refresh);
    connect(&styles, &StyleFiles::wanted, &strip, &view::StyleStrip::putOn);
    connect(&strip, &view::StyleStrip::saveStyleRequested, &styles, &StyleFiles::save);
    connect(&strip, &view::StyleStrip::renameStyleRequested, &styles, &StyleFiles::rename);
    connect(&strip, &view::StyleStrip::deleteStyleRequested, &styles, &StyleFiles::remove);
    connect(&strip, &view::StyleStrip::pictureWanted, &m_pictures, &StylePictures::make);
    connect(&m_pictures, &StylePictures::made, &strip, &view::StyleStrip::setPicture);
    connect(&strip, &view::StyleStrip::failed, this, &StyleStripController::failed);
}

void StyleStripController::refresh()
{
    m_jobs.start<StyleList>(
        tr("Reading the styles"),
        [](const model::Progress&) -> model::Result<StyleList> {
            StyleList list;
            list.entries = listStyles(&list.problems);
            return list;
        },
        this,
        [this, number = ++m_newest](const model::Result<StyleList>& list) {
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
