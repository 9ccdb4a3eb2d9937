// Random numbers, and advisory locks where there are such.
#include "model/disk/staged_names.h"

#include <QRandomGenerator>

#ifdef Q_OS_UNIX
#include <sys/file.h>
#endif

namespace hairpaint::model {

QString stagedNameIn(const QString& folder)
{
    const quint64 number = QRandomGenerator::global()->generate64();
    return QStringLiteral("%1/.hairpaint-%2.part").arg(folder).arg(number, 16, 16, QLatin1Char('0'));
}

QString stagedNamePattern()
{
    return QStringLiteral(".hairpaint-????????????????.part");
}

void holdStaged([[maybe_unused]] const QFile& file)
{
#ifdef Q_OS_UNIX
    (void)::flock(file.handle(), LOCK_EX | LOCK_NB);
#endif
}

} // namespace hairpaint::model
