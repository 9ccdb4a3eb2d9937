// See the header.
#include "view/widgets/melanin_sliders.h"

#include "view/look/theme.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/tool_setting_slider.h"

#include <QVBoxLayout>

#include <utility>

namespace hairpaint::view {

namespace {

constexpr double kPercentsOfMelanin = 100.0;

} // namespace

MelaninSliders::MelaninSliders(EditorState& state,
                               std::function<void(model::ToolSettings& settings, const QColor& colour)> set,
                               QWidget* parent)
    : QWidget(parent), m_melanin(new BarSlider(tr("Melanin"), this)), m_redness(new BarSlider(tr("Redness"), this))
{
    m_melanin->setHint(tr("The pigment of hair that is not dyed: from white to black"));
    m_redness->setHint(tr("How much of the pigment is the red one"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::kGap);
    for (BarSlider* slider : {m_melanin, m_redness}) {
        slider->setRange(0.0, kPercentsOfMelanin);
        slider->setUnit(QStringLiteral("%"));
        column->addWidget(slider);
        bindToolSettings(*slider, state, [this, set](model::ToolSettings& settings, double /*shown*/) {
            set(settings, melaninColour(shown()));
        });
    }
}

Melanin MelaninSliders::shown() const
{
    return {.amount = m_melanin->value() / kPercentsOfMelanin, .redness = m_redness->value() / kPercentsOfMelanin};
}

void MelaninSliders::showColour(const QColor& colour)
{
    if (melaninColour(shown()).rgb() != colour.rgb()) {
        const Melanin nearest = nearestMelanin(colour);
        m_melanin->setValue(kPercentsOfMelanin * nearest.amount);
        m_redness->setValue(kPercentsOfMelanin * nearest.redness);
    }
    const Melanin now = shown();
    QList<QColor> darker;
    QList<QColor> redder;
    constexpr int kSteps = 17;
    for (int i = 0; i < kSteps; ++i) {
        const double along = static_cast<double>(i) / (kSteps - 1);
        darker.append(melaninColour({.amount = along, .redness = now.redness}));
        redder.append(melaninColour({.amount = now.amount, .redness = along}));
    }
    m_melanin->setGradient(darker);
    m_redness->setGradient(redder);
}

} // namespace hairpaint::view
