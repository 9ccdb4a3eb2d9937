// Opening, linking and renaming.
#include "model/disk/staged_file.h"

#include "model/disk/atomic_file.h"
#include "model/disk/staged_names.h"
#include "model/values/sentences.h"

#include <QFileInfo>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>
#endif

namespace hairpaint::model {

StagedFile::StagedFile(const QString& path) : m_path(path)
{
    m_file.setFileName(m_path);
}

StagedFile::~StagedFile()
{
    m_file.close();
    if (!m_stagedName.isEmpty())
        (void)QFile::remove(m_stagedName);
}

bool StagedFile::openNameless()
{
#ifdef O_TMPFILE
    constexpr mode_t kByUmask = 0666;
    const QByteArray folder = QFile::encodeName(QFileInfo(m_path).path());
    const int descriptor = ::open(folder.constData(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kByUmask);
    if (descriptor < 0)
        return false; // Not every file system can.
    if (m_file.open(descriptor, QIODevice::WriteOnly | QIODevice::Unbuffered, QFileDevice::AutoCloseHandle))
        return true;
    (void)::close(descriptor);
#endif
    return false;
}

bool StagedFile::open()
{
    const QFileInfo before(m_path);
    if (before.exists() && !before.isWritable()) {
        // Its folder would let it be replaced, but it is not meant to be.
        (void)m_file.open(QIODevice::ReadWrite | QIODevice::ExistingOnly);
        m_file.close();
        return false;
    }
    if (!openNameless()) {
        const QString folder = before.path();
        bool opened = false;
        for (int tries = 0; tries < kStagedNameTries && !opened; ++tries) {
            m_file.setFileName(stagedNameIn(folder));
            opened = m_file.open(QIODevice::WriteOnly | QIODevice::NewOnly | QIODevice::Unbuffered);
            if (!opened && !QFileInfo::exists(m_file.fileName()))
                return false;
        }
        if (!opened)
            return false;
        m_stagedName = m_file.fileName();
    }
    holdStaged(m_file);
    if (before.exists())
        (void)m_file.setPermissions(before.permissions());
    return true;
}

bool StagedFile::nameIt()
{
#ifdef O_TMPFILE
    const QByteArray open = "/proc/self/fd/" + QByteArray::number(m_file.handle());
    for (int tries = 0; tries < kStagedNameTries; ++tries) {
        const QString name = stagedNameIn(QFileInfo(m_path).path());
        if (::linkat(AT_FDCWD, open.constData(), AT_FDCWD, QFile::encodeName(name).constData(), AT_SYMLINK_FOLLOW) ==
            0) {
            m_stagedName = name;
            return true;
        }
        if (errno != EEXIST)
            break;
    }
    m_problem = writeRefusal(qt_error_string(errno));
#endif
    return false;
}

bool StagedFile::publish()
{
    if (m_stagedName.isEmpty() && !nameIt())
        return false;
#ifndef Q_OS_UNIX
    m_file.close(); // What is open can't be renamed there.
#endif
    if (!replaceFile(m_stagedName, m_path)) {
        m_problem = writeRefusal(qt_error_string());
        return false;
    }
    m_stagedName.clear();
    m_file.close();
    return true;
}

} // namespace hairpaint::model
