// Small flat icon buttons with a tooltip and an accessible name.
#pragma once

#include <QToolButton>

namespace hairpaint::view {

[[nodiscard]] QToolButton* makeActionButton(const QString& iconName, const QString& name, QWidget* parent);

} // namespace hairpaint::view
