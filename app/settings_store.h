// The file in which settings lie: settings.json in the program's configuration folder.
#pragma once

#include <QJsonObject>
#include <QString>
#include <QVariant>

namespace hairpaint::app {

/// Values by key, of the kinds that JSON has, and bytes. Read and written whole at each change, through the one writer
/// of files: QSettings would leave an empty file on a full disk. Where the file can't be written, what is set holds for
/// this object. What 0.1 left in QSettings is taken over where there is no file yet. GUI thread.
class SettingsStore
{
public:
    SettingsStore();
    explicit SettingsStore(QString path);

    [[nodiscard]] QVariant value(const QString& key, const QVariant& otherwise = {}) const;
    void setValue(const QString& key, const QVariant& value);
    void remove(const QString& key);
    void clear();

private:
    void read();
    void write();

    QString m_path;
    QJsonObject m_values;
};

} // namespace hairpaint::app
