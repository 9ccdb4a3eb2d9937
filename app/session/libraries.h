// Which libraries the program stands on.
#pragma once

#include <QStringList>

namespace hairpaint::app {

/// "NAME VERSION" of each, in the order of the README's table: Qt as it runs, the others as they were built with.
[[nodiscard]] QStringList librariesInUse();

} // namespace hairpaint::app
