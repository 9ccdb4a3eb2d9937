#include "tests/support/locations.h"

namespace hairpaint::test {

QString sourcePath(QStringView inside)
{
    return QStringLiteral(HAIRPAINT_SOURCE_DIR "/") + inside.toString();
}

QString dataPath(QStringView inside)
{
    return QStringLiteral(HAIRPAINT_SOURCE_DIR "/tests/data/") + inside.toString();
}

QString buildFolder()
{
    return QStringLiteral(HAIRPAINT_BUILD_DIR);
}

QString hairpaintProgram()
{
    return QStringLiteral(HAIRPAINT_PROGRAM);
}

QString importProgram()
{
    return QStringLiteral(HAIRPAINT_IMPORT_PROGRAM);
}

QString fakeHelper()
{
    return QStringLiteral(HAIRPAINT_FAKE_HELPER_PROGRAM);
}

} // namespace hairpaint::test
