// Renaming from a folder on the same disk.
#include "model/disk/staged_files.h"

#include "model/disk/atomic_file.h"
#include "model/disk/output_path.h"
#include "model/disk/staged_names.h"
#include "model/disk/staged_sweep.h"
#include "model/values/sentences.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <filesystem>
#include <system_error>

namespace hairpaint::model {

namespace {

QString problemOf(const Checked<void>& done)
{
    return done ? QString() : done.error().text;
}

/// To another disk, where no name can be moved to.
QString copyOver(const QString& from, const QString& to)
{
    QFile file(from);
    return file.open(QIODevice::ReadOnly) ? problemOf(copyFile(file, to)) : readRefusal(file.errorString());
}

/// Over what lies there. A clause on what went wrong; empty where nothing did.
QString moveFile(const QString& from, const QString& to)
{
    std::error_code problem;
    std::filesystem::rename(QFileInfo(from).filesystemFilePath(), QFileInfo(to).filesystemFilePath(), problem);
    if (problem == std::errc::cross_device_link)
        return copyOver(from, to);
    return problem ? writeRefusal(QString::fromLocal8Bit(problem.message())) : QString();
}

/// Gives it a second name, so that the first always names a file; the first goes where a disk knows no such names.
QString keepFile(const QString& file, const QString& as)
{
    std::error_code problem;
    std::filesystem::create_hard_link(QFileInfo(file).filesystemFilePath(), QFileInfo(as).filesystemFilePath(),
                                      problem);
    return problem ? moveFile(file, as) : QString();
}

} // namespace

StagedFiles::StagedFiles(const QString& folder)
{
    (void)sweepStaged(folder);
    for (int tries = 0; tries < kStagedNameTries && m_folder.isEmpty(); ++tries)
        if (const QString path = stagedNameIn(folder); makeFolder(path))
            m_folder = path;
}

bool StagedFiles::makeFolder(const QString& path)
{
    std::error_code problem;
    std::filesystem::create_directory(QFileInfo(path).filesystemFilePath(), problem);
    if (problem) {
        m_problem = writeRefusal(QString::fromLocal8Bit(problem.message()));
        return false;
    }
    m_lock.setFileName(path + QLatin1Char('/') + kLockName);
    if (m_lock.open(QIODevice::WriteOnly | QIODevice::NewOnly)) {
        holdStaged(m_lock);
        if (m_lock.exists())
            return true;
        m_lock.close(); // Somebody who sweeps was between the two.
    } else {
        m_problem = writeRefusal(m_lock.errorString());
    }
    (void)QDir().rmdir(path);
    return false;
}

StagedFiles::~StagedFiles()
{
    if (m_folder.isEmpty())
        return;
    for (const QString& name : m_names)
        (void)QFile::remove(stagedPath(name));
    for (qsizetype i = 0; i < m_asideCount; ++i)
        (void)QFile::remove(asideFor(i));
    (void)QDir().rmdir(stagedPath(kAsideName));
    (void)m_lock.remove();
    (void)QDir().rmdir(m_folder);
}

Result<void> StagedFiles::check(const QString& path) const
{
    if (!m_folder.isEmpty())
        return {};
    return cannotWrite(path, {.text = m_problem});
}

QString StagedFiles::stagedPath(const QString& name) const
{
    return m_folder + QLatin1Char('/') + name;
}

QString StagedFiles::pathFor(const QString& path)
{
    const QString name = QFileInfo(path).fileName();
    if (!m_names.contains(name))
        m_names += name;
    return stagedPath(name);
}

Error StagedFiles::named(Error error, const QString& path) const
{
    error.message.replace(shownPath(stagedPath(QFileInfo(path).fileName())), shownPath(path));
    return error;
}

Result<void> StagedFiles::publish(const QStringList& wanted)
{
    QStringList targets; // Behind links.
    for (const QString& path : wanted) {
        const Checked<QString> behind = outputPath(path);
        if (!behind)
            return cannotWrite(path, behind.error());
        targets += *behind;
    }
    // What lies there is put aside first, so that it can be put back.
    if (!QDir().mkpath(stagedPath(kAsideName)))
        return cannotWrite(wanted.front(), {.text = writeRefusal(qt_error_string())});
    qsizetype& aside = m_asideCount;
    qsizetype moved = 0;
    QString problem;
    for (; aside < targets.size() && problem.isEmpty(); ++aside)
        if (QFileInfo::exists(targets[aside]))
            problem = keepFile(targets[aside], asideFor(aside));
    for (; moved < targets.size() && problem.isEmpty(); ++moved)
        problem = moveFile(pathFor(wanted[moved]), targets[moved]);
    if (problem.isEmpty())
        return {};
    const QString& failed = wanted[moved > 0 ? moved - 1 : aside - 1];
    for (qsizetype i = 0; i < aside; ++i) {
        if (QFileInfo::exists(asideFor(i)))
            (void)moveFile(asideFor(i), targets[i]);
        else if (i < moved)
            (void)QFile::remove(targets[i]);
    }
    return cannotWrite(failed, {.text = problem});
}

QString StagedFiles::asideFor(qsizetype number) const
{
    return stagedPath(QStringLiteral("%1/%2").arg(kAsideName).arg(number));
}

} // namespace hairpaint::model
