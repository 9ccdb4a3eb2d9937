// The file in which settings lie: settings.json in the program's configuration folder.
#pragma once

#include "app/settings/settings_file.h"

#include <QJsonObject>
#include <QObject>
#include <QSet>
#include <QString>
#include <QTimer>
#include <QVariant>

namespace hairpaint::app {

/// Values by key, of the kinds that JSON has, and bytes. What was set is put into the file once the event loop is
/// reached, on another thread and through the one writer of files: QSettings would leave an empty file on a full disk.
/// Only the keys that were set are: another window may have written the others. Where the file can't be written, what
/// is set holds for this object and is tried again with the next. What 0.1 left in QSettings is taken over where there
/// is no file yet. A file that is not an ordinary one, or is too large, holds no settings; where the disk does not
/// answer in time when it is read, the defaults hold and nothing is written. GUI thread, which waits only to begin with
/// and in flush().
class SettingsStore : public QObject
{
    Q_OBJECT
public:
    static constexpr int kPatienceMs = 2000; ///< With the disk.

    SettingsStore();
    explicit SettingsStore(QString path, int patienceMs = kPatienceMs);
    ~SettingsStore() override; ///< Flushes.

    [[nodiscard]] QVariant value(const QString& key, const QVariant& otherwise = {}) const;
    void setValue(const QString& key, const QVariant& value);
    void remove(const QString& key);
    void clear();
    /// What was set is in the file when it returns, or can't be; a disk that does not answer is left to itself.
    void flush();

private:
    void changed(const QString& key);
    void post(bool isClearing = false);
    void adoptWritten(); ///< What the file has by now.

    SettingsFile m_file;
    bool m_isUnread = false; ///< The disk has not answered.
    QJsonObject m_values;
    QSet<QString> m_changed; ///< Set or removed and not known to be in the file.
    QTimer m_soon;
};

} // namespace hairpaint::app
