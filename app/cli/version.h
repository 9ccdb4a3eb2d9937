// What `hairpaint --version` prints.
#pragma once

#include <QStringList>

namespace hairpaint::app {

/// The version, the libraries, and which layers hold the helper that decodes foreign files on this machine, as it finds
/// them itself.
[[nodiscard]] QStringList versionLines();

} // namespace hairpaint::app
