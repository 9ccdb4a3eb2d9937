// Settings as JSON: see the header.
#include "app/settings/settings_store.h"

#include "app/background/counted_thread.h"
#include "model/disk/atomic_file.h"
#include "model/disk/own_folder.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QSettings>
#include <QStandardPaths>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <utility>

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

SettingsStore::SettingsStore(QString path, int patienceMs) : m_path(std::move(path)), m_patienceMs(patienceMs)
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(0);
    connect(&m_soon, &QTimer::timeout, this, &SettingsStore::flush);
    if (std::optional<QJsonObject> values = read(); values || m_isSilent) {
        m_values = std::move(values).value_or(QJsonObject());
        return;
    }
    const QSettings before;
    const QStringList keys = before.allKeys();
    for (const QString& key : keys)
        m_values.insert(key, toJson(before.value(key)));
    m_changed = QSet<QString>(keys.begin(), keys.end());
}

SettingsStore::~SettingsStore()
{
    flush();
}

QVariant SettingsStore::value(const QString& key, const QVariant& otherwise) const
{
    const auto found = m_values.constFind(key);
    return found == m_values.constEnd() ? otherwise : fromJson(*found);
}

void SettingsStore::setValue(const QString& key, const QVariant& value)
{
    const QJsonValue next = toJson(value);
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
    (void)write();
}

void SettingsStore::changed(const QString& key)
{
    m_changed.insert(key);
    m_soon.start();
}

void SettingsStore::flush()
{
    m_soon.stop();
    if (m_changed.isEmpty() || m_isSilent)
        return;
    QJsonObject merged = read().value_or(QJsonObject());
    if (m_isSilent)
        return;
    for (const QString& key : m_changed) {
        if (m_values.contains(key))
            merged.insert(key, m_values.value(key));
        else
            merged.remove(key);
    }
    m_values = merged;
    if (write())
        m_changed.clear();
}

std::optional<QJsonObject> SettingsStore::read()
{
    struct Answer
    {
        std::mutex mutex;
        std::condition_variable came;
        bool isThere = false;
        std::optional<QJsonObject> values;
    };
    const auto answer = std::make_shared<Answer>();
    // A thread that is left to itself where the disk never answers.
    countedThread([answer, path = m_path] {
        std::optional<QJsonObject> values;
        if (QFileInfo::exists(path))
            values =
                QJsonDocument::fromJson(model::contentOfOrdinaryFile(path, kMostBytes).value_or(QByteArray())).object();
        const std::lock_guard lock(answer->mutex);
        answer->values = std::move(values);
        answer->isThere = true;
        answer->came.notify_one();
    }).detach();
    std::unique_lock lock(answer->mutex);
    m_isSilent =
        !answer->came.wait_for(lock, std::chrono::milliseconds(m_patienceMs), [&answer] { return answer->isThere; });
    return m_isSilent ? std::nullopt : std::move(answer->values);
}

bool SettingsStore::write()
{
    // A full disk must not stop the work; the old settings stay.
    return QDir().mkpath(QFileInfo(m_path).absolutePath()) &&
           model::writeFile(m_path, QJsonDocument(m_values).toJson()).has_value();
}

} // namespace hairpaint::app
