// The sliders of each kind of cut.
#include "view/dialogs/cut_dialog.h"

#include "model/values/names.h"
#include "view/look/theme.h"
#include "view/widgets/bar_slider.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace hairpaint::view {

namespace {

constexpr double kCmPerM = 100.0;
constexpr double kPercent = 100.0;
/// Corner of the jaw, as a fraction of the height from the ears' openings down to the chin.
constexpr float kJaw = 0.55F;
constexpr double kAboveChinCm = 30.0;
constexpr double kFadeTopCm = 5.0;
constexpr double kFadeEndsPercent =
    75.0; ///< Part of the way from the crown down to the nape: below the openings of the ears.

struct CutText
{
    const char* title;
    const char* remark;
    const char* step;
};

/// By HairCut.
constexpr std::array kCutTexts{
    CutText{QT_TRANSLATE_NOOP("CutDialog", "Trim"),
            QT_TRANSLATE_NOOP("CutDialog", "All hair of “%1” becomes shorter by as much; what is shorter than hair "
                                           "may become stays as it is."),
            QT_TRANSLATE_NOOP("CutDialog", "Trim hair")},
    CutText{QT_TRANSLATE_NOOP("CutDialog", "Cut to a level"),
            QT_TRANSLATE_NOOP("CutDialog", "Each hair of “%1” that hangs lower ends there, as it lies now."),
            QT_TRANSLATE_NOOP("CutDialog", "Cut hair to a level")},
    CutText{QT_TRANSLATE_NOOP("CutDialog", "Layers"),
            QT_TRANSLATE_NOOP("CutDialog", "Hair of “%1” is cut by its distance from the crown; what is shorter stays "
                                           "as it is."),
            QT_TRANSLATE_NOOP("CutDialog", "Cut layers")},
    CutText{QT_TRANSLATE_NOOP("CutDialog", "Fade"),
            QT_TRANSLATE_NOOP("CutDialog", "Hair of “%1” becomes shorter from the top down to the skin at the sides "
                                           "and the nape; what is shorter stays as it is."),
            QT_TRANSLATE_NOOP("CutDialog", "Cut a fade")},
};

model::ToolContext contextOf(EditorState& state, model::ToolSettings& settings)
{
    const model::LayerAddress target{.group = state.target().group(),
                                     .map = model::MapKind::Length,
                                     .layer = state.target().layer(model::MapKind::Length)};
    return {
        .document = state.document(), .target = target, .settings = settings, .selection = state.tools().selection()};
}

} // namespace

CutDialog::CutDialog(EditorState& state, HairCut kind, std::shared_ptr<const sim::StrandFrame> frame, QWidget* parent)
    : QDialog(parent), m_state(state), m_frame(std::move(frame)), m_settings(state.tools().settings()),
      m_context(contextOf(state, m_settings)),
      m_cut(m_context, m_frame, tr(kCutTexts.at(static_cast<std::size_t>(kind)).step)), m_rows(new QVBoxLayout(this))
{
    constexpr int kMargin = 16;
    constexpr int kWidth = 360;
    const CutText& text = kCutTexts.at(static_cast<std::size_t>(kind));
    setWindowTitle(tr(text.title));
    m_rows->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    m_rows->setSpacing(metrics::kGap);
    const model::HairGroup* group = m_state.document().committed().group(m_context.target.group);
    addRemark(tr(text.remark).arg(group != nullptr ? model::shownName(group->name) : QString()));
    switch (kind) {
    case HairCut::Trim:
        addTrim();
        break;
    case HairCut::Level:
        addLevel();
        break;
    case HairCut::Layers:
    case HairCut::Fade:
        addGrade(kind == HairCut::Fade);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Cut"));
    buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    m_rows->addSpacing(metrics::kGrid);
    m_rows->addWidget(buttons);
    setMinimumWidth(kWidth);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    preview();
}

QString CutDialog::nothingToCutText()
{
    return tr("There is no hair to cut in this group.");
}

void CutDialog::addRemark(const QString& text)
{
    auto* remark = new QLabel(text, this);
    remark->setTextFormat(Qt::PlainText);
    remark->setWordWrap(true);
    m_rows->addWidget(remark);
}

BarSlider* CutDialog::addSlider(const QString& label, double least, double greatest, int decimals, double start,
                                const QString& unit)
{
    auto* slider = new BarSlider(label, this);
    slider->setRange(least, greatest, decimals);
    slider->setUnit(unit);
    slider->setDefaultValue(start);
    slider->setValue(start);
    connect(slider, &BarSlider::valueChanged, this, &CutDialog::preview);
    connect(slider, &BarSlider::editingCancelled, this, &CutDialog::preview);
    m_rows->addWidget(slider);
    m_sliders.push_back(slider);
    return slider;
}

BarSlider* CutDialog::addLength(const QString& label, double greatestCm, double startCm)
{
    BarSlider* slider = addSlider(label, 0.0, greatestCm, 1, std::min(startCm, greatestCm), tr("cm"));
    slider->setExponent(2.0);
    return slider;
}

void CutDialog::addTrim()
{
    const double longestCm = std::max(std::ceil(static_cast<double>(m_cut.longestM()) * kCmPerM), 1.0);
    const BarSlider* by = addLength(tr("Shorter by"), longestCm, 1.0);
    const BarSlider* least = addLength(tr("No shorter than"), longestCm, 1.0);
    m_preview = [this, by, least] {
        m_cut.trim(static_cast<float>(by->value() / kCmPerM), static_cast<float>(least->value() / kCmPerM));
    };
}

void CutDialog::addLevel()
{
    const std::optional<sim::HeadLandmarks>& marks = m_state.document().project().head->landmarks;
    // Without landmarks from the head's centre.
    const float zeroHd = marks ? (*marks)[sim::HeadLandmark::Chin].y : 0.0F;
    const double lowestCm = std::floor(static_cast<double>(m_cut.lowestHd() - zeroHd) * kCmPerM);
    const double least = std::clamp(lowestCm, -200.0, 0.0);
    BarSlider* level = addSlider(marks ? tr("Above the chin") : tr("Height"), least, kAboveChinCm, 1, least, tr("cm"));
    m_preview = [this, level, zeroHd] { m_cut.toLevel(zeroHd + static_cast<float>(level->value() / kCmPerM)); };
    if (!marks)
        return;
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGap);
    const auto add = [&](const QString& text, float heightHd) {
        auto* button = new QPushButton(text, this);
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this, [this, level, heightHd, zeroHd] {
            level->setValue(static_cast<double>(heightHd - zeroHd) * kCmPerM);
            preview();
        });
        row->addWidget(button);
    };
    const float earsHd = 0.5F * ((*marks)[sim::HeadLandmark::EarLeft].y + (*marks)[sim::HeadLandmark::EarRight].y);
    add(tr("Ears"), earsHd);
    add(tr("Jaw"), glm::mix(earsHd, zeroHd, kJaw));
    add(tr("Chin"), zeroHd);
    if (m_frame->neck.hasShoulders())
        add(tr("Shoulders"), m_frame->neck.shouldersY);
    m_rows->addLayout(row);
}

void CutDialog::addGrade(bool fades)
{
    const double longestCm = std::max(std::ceil(static_cast<double>(m_cut.longestM()) * kCmPerM), 1.0);
    const std::optional<sim::HeadLandmarks>& marks = m_state.document().project().head->landmarks;
    model::GradedLengths grade{.fades = fades};
    if (marks) {
        grade.topHd = (*marks)[sim::HeadLandmark::Crown];
        grade.bottomHd = (*marks)[sim::HeadLandmark::Nape];
    } else {
        std::tie(grade.bottomHd, grade.topHd) = m_cut.lowestAndHighestRoot();
    }
    const BarSlider* top = addLength(fades ? tr("Length at the top") : tr("Length at the crown"), longestCm,
                                     fades ? kFadeTopCm : 0.5 * longestCm);
    const BarSlider* bottom =
        addLength(fades ? tr("Length at the hairline") : tr("Length at the nape"), longestCm, fades ? 0.1 : longestCm);
    const BarSlider* from = addSlider(tr("Begins at"), 0.0, kPercent, 0, fades ? 10.0 : 0.0, QStringLiteral("%"));
    const BarSlider* to =
        addSlider(tr("Ends at"), 0.0, kPercent, 0, fades ? kFadeEndsPercent : kPercent, QStringLiteral("%"));
    m_preview = [this, grade, top, bottom, from, to]() mutable {
        grade.topM = static_cast<float>(top->value() / kCmPerM);
        grade.bottomM = static_cast<float>(bottom->value() / kCmPerM);
        grade.from = static_cast<float>(from->value() / kPercent);
        grade.to = static_cast<float>(to->value() / kPercent);
        m_cut.grade(grade);
    };
}

void CutDialog::accept()
{
    for (BarSlider* slider : m_sliders)
        slider->release();
    m_cut.commit();
    QDialog::accept();
}

void CutDialog::reject()
{
    m_cut.cancel();
    QDialog::reject();
}

} // namespace hairpaint::view
