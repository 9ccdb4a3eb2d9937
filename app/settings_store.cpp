// Settings as JSON: see the header.
#include "app/settings_store.h"

#include "model/files/atomic_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QSettings>
#include <QStandardPaths>

namespace hairpaint::app {

namespace {

constexpr qint64 kMostBytes = 1 << 20;
const QString kBytesMark = QStringLiteral("base64:");

QJsonValue toJson(const QVariant& value)
{
    if (value.typeId() == QMetaType::QByteArray)
        return kBytesMark + QString::fromLatin1(value.toByteArray().toBase64());
    return QJsonValue::fromVariant(value);
}

QVariant fromJson(const QJsonValue& value)
{
    const QString text = value.toString();
    if (text.startsWith(kBytesMark))
        return QByteArray::fromBase64(text.sliced(kBytesMark.size()).toLatin1());
    return value.toVariant();
}

} // namespace

SettingsStore::SettingsStore()
    : SettingsStore(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) +
                    QStringLiteral("/settings.json"))
{}

SettingsStore::SettingsStore(QString path) : m_path(std::move(path))
{
    if (QFileInfo::exists(m_path)) {
        read();
        return;
    }
    const QSettings before;
    const QStringList keys = before.allKeys();
    for (const QString& key : keys)
        m_values.insert(key, toJson(before.value(key)));
}

QVariant SettingsStore::value(const QString& key, const QVariant& otherwise) const
{
    const auto found = m_values.constFind(key);
    return found == m_values.constEnd() ? otherwise : fromJson(*found);
}

void SettingsStore::setValue(const QString& key, const QVariant& value)
{
    read(); // Another window may have written meanwhile.
    m_values.insert(key, toJson(value));
    write();
}

void SettingsStore::remove(const QString& key)
{
    read();
    m_values.remove(key);
    write();
}

void SettingsStore::clear()
{
    m_values = {};
    write();
}

void SettingsStore::read()
{
    QFile file(m_path);
    if (!file.open(QIODevice::ReadOnly) || file.size() > kMostBytes)
        return;
    const QJsonDocument document = QJsonDocument::fromJson(file.readAll());
    if (document.isObject())
        m_values = document.object();
}

void SettingsStore::write()
{
    // A full disk must not stop the work; the old settings stay.
    if (QDir().mkpath(QFileInfo(m_path).absolutePath()))
        (void)model::writeFile(m_path, QJsonDocument(m_values).toJson());
}

} // namespace hairpaint::app
