// The file in which settings lie: settings.json in the program's configuration folder.
#pragma once

#include <QJsonObject>
#include <QObject>
#include <QSet>
#include <QString>
#include <QTimer>
#include <QVariant>

#include <optional>

namespace hairpaint::app {

/// Values by key, of the kinds that JSON has, and bytes. What was set is put into the file once the event loop is
/// reached, through the one writer of files: QSettings would leave an empty file on a full disk. Only the keys that
/// were set are: another window may have written the others. Where the file can't be written, what is set holds for
/// this object and is tried again with the next. What 0.1 left in QSettings is taken over where there is no file yet.
/// A file that is not an ordinary one, or is too large, holds no settings; where the disk does not answer in time, the
/// defaults hold and nothing is written. GUI thread.
class SettingsStore : public QObject
{
    Q_OBJECT
public:
    static constexpr int kPatienceMs = 2000; ///< With the disk; nothing is shown until it has answered.

    SettingsStore();
    explicit SettingsStore(QString path, int patienceMs = kPatienceMs);
    ~SettingsStore() override; ///< Flushes.

    [[nodiscard]] QVariant value(const QString& key, const QVariant& otherwise = {}) const;
    void setValue(const QString& key, const QVariant& value);
    void remove(const QString& key);
    void clear();
    void flush(); ///< Writes at once what was set.

private:
    void changed(const QString& key);
    /// As the file has them; none where there is no file, or it has not answered.
    [[nodiscard]] std::optional<QJsonObject> read();
    bool write();

    QString m_path;
    int m_patienceMs;
    bool m_isSilent = false; ///< The disk has not answered.
    QJsonObject m_values;
    QSet<QString> m_changed; ///< Set or removed and not in the file yet.
    QTimer m_soon;
};

} // namespace hairpaint::app
