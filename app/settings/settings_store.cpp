// Settings as JSON: see the header.
#include "app/settings/settings_store.h"

#include <QStandardPaths>

#include <chrono>
#include <utility>

namespace hairpaint::app {

SettingsStore::SettingsStore()
    : SettingsStore(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) +
                    QStringLiteral("/settings.json"))
{}

SettingsStore::SettingsStore(QString path, int patienceMs)
    : m_file(std::move(path), std::chrono::milliseconds(patienceMs))
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(0);
    connect(&m_soon, &QTimer::timeout, this, [this] { post(); });
    const std::optional<SettingsFile::Content> content = m_file.read();
    m_isUnread = !content;
    if (!content)
        return;
    m_values = content->values;
    const QStringList keys = m_values.keys();
    if (!content->exists)
        m_changed = QSet<QString>(keys.begin(), keys.end());
}

SettingsStore::~SettingsStore()
{
    flush();
}

QVariant SettingsStore::value(const QString& key, const QVariant& otherwise) const
{
    const auto found = m_values.constFind(key);
    return found == m_values.constEnd() ? otherwise : settingFromJson(*found);
}

void SettingsStore::setValue(const QString& key, const QVariant& value)
{
    const QJsonValue next = settingToJson(value);
    if (m_values.value(key) == next && m_values.contains(key))
        return;
    m_values.insert(key, next);
    changed(key);
}

void SettingsStore::remove(const QString& key)
{
    if (!m_values.contains(key))
        return;
    m_values.remove(key);
    changed(key);
}

void SettingsStore::clear()
{
    m_values = {};
    m_changed.clear();
    if (m_isUnread)
        return;
    post(true);
    flush();
}

void SettingsStore::changed(const QString& key)
{
    m_changed.insert(key);
    m_soon.start();
}

void SettingsStore::post(bool isClearing)
{
    m_soon.stop();
    adoptWritten();
    if (m_isUnread || (m_changed.isEmpty() && !isClearing))
        return;
    SettingsFile::Changes changes;
    for (const QString& key : std::as_const(m_changed))
        changes.insert(key, m_values.value(key));
    m_file.write(std::move(changes), isClearing);
}

void SettingsStore::adoptWritten()
{
    const std::optional<SettingsFile::Written> written = m_file.takeWritten();
    if (!written || !written->isDone)
        return;
    m_changed.removeIf([&](const QString& key) {
        const auto change = written->changes.constFind(key);
        return change != written->changes.constEnd() && *change == m_values.value(key);
    });
    QJsonObject values = written->values;
    for (const QString& key : std::as_const(m_changed)) {
        if (m_values.contains(key))
            values.insert(key, m_values.value(key));
        else
            values.remove(key);
    }
    m_values = std::move(values);
}

void SettingsStore::flush()
{
    post();
    if (m_file.finish())
        adoptWritten();
}

} // namespace hairpaint::app
