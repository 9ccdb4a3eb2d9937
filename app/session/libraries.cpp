// What CMake found when it was configured.
#include "app/session/libraries.h"

#include <QtGlobal>

namespace hairpaint::app {

QStringList librariesInUse()
{
    return QStringList{QStringLiteral("Qt %1").arg(QLatin1String(qVersion()))} +
           QStringLiteral(HAIRPAINT_LIBRARIES).split(QLatin1Char('|'));
}

} // namespace hairpaint::app
