// Threads for reading and writing settings.
#include "app/settings/settings_file.h"

#include "app/background/counted_thread.h"
#include "model/disk/atomic_file.h"
#include "model/disk/own_folder.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QSettings>

#include <condition_variable>
#include <mutex>
#include <utility>

namespace hairpaint::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr qint64 kMostBytes = 1 << 20;
const QString kBytesMark = QStringLiteral("base64:");

QJsonObject valuesOf(const QString& path)
{
    return QJsonDocument::fromJson(model::contentOfOrdinaryFile(path, kMostBytes).value_or(QByteArray())).object();
}

SettingsFile::Content contentOf(const QString& path)
{
    if (QFileInfo::exists(path))
        return {.values = valuesOf(path), .exists = true};
    SettingsFile::Content content;
    const QSettings before;
    for (const QString& key : before.allKeys())
        content.values.insert(key, settingToJson(before.value(key)));
    return content;
}

/// A full disk must not stop the work; the old settings stay.
bool put(const QString& path, const QJsonObject& values)
{
    return QDir().mkpath(QFileInfo(path).absolutePath()) &&
           model::writeFile(path, QJsonDocument(values).toJson()).has_value();
}

} // namespace

QJsonValue settingToJson(const QVariant& value)
{
    if (value.typeId() == QMetaType::QByteArray)
        return kBytesMark + QString::fromLatin1(value.toByteArray().toBase64());
    return QJsonValue::fromVariant(value);
}

QVariant settingFromJson(const QJsonValue& value)
{
    const QString text = value.toString();
    if (text.startsWith(kBytesMark))
        return QByteArray::fromBase64(text.sliced(kBytesMark.size()).toLatin1());
    return value.toVariant();
}

/// Owned by the threads too: one may answer when nobody is left.
struct SettingsFile::Shared
{
    struct Order
    {
        Changes changes;
        bool isClearing = false;
    };

    explicit Shared(QString where) : path(std::move(where)) {}

    const QString path;

    std::mutex mutex; ///< Guards the members below.
    std::condition_variable changed;
    std::optional<Order> waiting;
    std::optional<Clock::time_point> busySince; ///< While a thread writes.
    std::optional<Written> written;
};

SettingsFile::SettingsFile(QString path, std::chrono::milliseconds patience)
    : m_patience(patience), m_shared(std::make_shared<Shared>(std::move(path)))
{}

std::optional<SettingsFile::Content> SettingsFile::read() const
{
    struct Answer
    {
        std::mutex mutex;
        std::condition_variable came;
        std::optional<Content> content;
    };
    const auto answer = std::make_shared<Answer>();
    countedThread([answer, path = m_shared->path] {
        Content content = contentOf(path);
        const std::scoped_lock lock(answer->mutex);
        answer->content = std::move(content);
        answer->came.notify_one();
    }).detach();
    std::unique_lock lock(answer->mutex);
    (void)answer->came.wait_for(lock, m_patience, [&answer] { return answer->content.has_value(); });
    return std::move(answer->content);
}

void SettingsFile::write(Changes changes, bool isClearing)
{
    const std::scoped_lock lock(m_shared->mutex);
    const bool wasClearing = m_shared->waiting && m_shared->waiting->isClearing;
    m_shared->waiting = {.changes = std::move(changes), .isClearing = isClearing || wasClearing};
    if (m_shared->busySince)
        return;
    m_shared->busySince = Clock::now();
    countedThread([shared = m_shared] { work(*shared); }).detach();
}

void SettingsFile::work(Shared& shared)
{
    std::unique_lock lock(shared.mutex);
    while (shared.waiting) {
        Shared::Order order = *std::exchange(shared.waiting, std::nullopt);
        shared.busySince = Clock::now();
        lock.unlock();
        QJsonObject values = order.isClearing ? QJsonObject() : valuesOf(shared.path);
        for (auto change = order.changes.cbegin(); change != order.changes.cend(); ++change) {
            if (change->isUndefined())
                values.remove(change.key());
            else
                values.insert(change.key(), *change);
        }
        const bool isDone = put(shared.path, values);
        lock.lock();
        shared.written = {.values = std::move(values), .changes = std::move(order.changes), .isDone = isDone};
    }
    shared.busySince.reset();
    shared.changed.notify_all();
}

bool SettingsFile::finish() const
{
    std::unique_lock lock(m_shared->mutex);
    while (m_shared->busySince) {
        const Clock::time_point end = *m_shared->busySince + m_patience;
        if (Clock::now() >= end)
            return false;
        m_shared->changed.wait_until(lock, end);
    }
    return true;
}

std::optional<SettingsFile::Written> SettingsFile::takeWritten()
{
    const std::scoped_lock lock(m_shared->mutex);
    return std::exchange(m_shared->written, std::nullopt);
}

} // namespace hairpaint::app
