// Where this checkout, its tests' files and the programs that were built with them lie.
#pragma once

#include <QString>

namespace hairpaint::test {

// Whole paths. Only locations.cpp is compiled with them: all other tests find themselves in the compiler's cache when
// they were built in another folder before.
[[nodiscard]] QString
sourcePath(QStringView inside); ///< From the top: "translations/hairpaint_es.ts". With '/' at its end where empty.
[[nodiscard]] QString dataPath(QStringView inside); ///< From tests/data: "golden/bob.png".
[[nodiscard]] QString buildFolder();
[[nodiscard]] QString hairpaintProgram();
[[nodiscard]] QString importProgram(); ///< hairpaint-import.
[[nodiscard]] QString fakeHelper();    ///< Stands for hairpaint-import, and misbehaves as it is told to.

} // namespace hairpaint::test
