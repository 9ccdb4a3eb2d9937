// Random numbers, and advisory locks where there are such.
#include "model/disk/staged_names.h"

#include <QRandomGenerator>

#ifdef Q_OS_UNIX
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
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

bool isHeldStaged([[maybe_unused]] const QString& path)
{
#ifdef Q_OS_UNIX
    const int descriptor = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
        return true;
    const bool held = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
    (void)::close(descriptor);
    return held;
#else
    return false;
#endif
}

} // namespace hairpaint::model
