// A brush made larger, softer or fainter with the pointer.
#include "view/editing/brush_drag.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

bool BrushDrag::press(const PointerSample& sample, const HeldKeys& keys)
{
    m_opacity = sample.button == Qt::LeftButton && keys.holds(Qt::Key_O);
    if (!m_opacity && !(sample.button == Qt::RightButton && sample.modifiers.testFlag(Qt::ControlModifier)))
        return false;
    m_pressed = sample.position;
    m_before = m_state.tools().settings();
    return true;
}

void BrushDrag::move(const PointerSample& sample)
{
    // Change of the size's logarithm: each pixel changes the size by the same factor.
    constexpr float kSizePerPx = 0.008F;
    constexpr float kPerPx = 0.004F;
    const auto right = static_cast<float>(sample.position.x() - m_pressed.x());
    const auto down = static_cast<float>(sample.position.y() - m_pressed.y());
    model::ToolSettings settings = m_before;
    if (m_opacity) {
        settings.opacity = std::clamp(m_before.opacity + right * kPerPx, 0.0F, 1.0F);
    } else {
        settings.brushSizeM = std::clamp(m_before.brushSizeM * std::exp(right * kSizePerPx), 0.001F, 0.3F);
        settings.hardness = std::clamp(m_before.hardness - down * kPerPx, 0.0F, 1.0F);
    }
    m_state.tools().setSettings(settings);
}

QString brushText(const model::ToolSettings& settings)
{
    const auto number = [](float value, int decimals) {
        return QLocale().toString(static_cast<double>(value), 'f', decimals);
    };
    return QCoreApplication::translate("BrushDrag", "Size %1 cm, hardness %2 %, opacity %3 %")
        .arg(number(settings.brushSizeM * 100.0F, 1), number(settings.hardness * 100.0F, 0),
             number(settings.opacity * 100.0F, 0));
}

} // namespace hairpaint::view
