// settings.json on its disk, which may not answer: whoever waits for it leaves it after a while.
#pragma once

#include <QHash>
#include <QJsonObject>
#include <QJsonValue>
#include <QString>
#include <QVariant>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

namespace hairpaint::app {

/// A setting as JSON; bytes become text.
[[nodiscard]] QJsonValue settingToJson(const QVariant& value);
[[nodiscard]] QVariant settingFromJson(const QJsonValue& value);

/// Reads and writes on counted threads of its own. All of it is called on one thread, the GUI's, which asks the disk
/// nothing.
class SettingsFile
{
public:
    using Changes = QHash<QString, QJsonValue>; ///< New values by key; undefined where the key was removed.
    struct Content
    {
        QJsonObject values;
        bool exists = false; ///< Whether the file exists; else the values are those of version 0.1 in QSettings.
    };
    struct Written
    {
        QJsonObject values; ///< All values in the file, those of other windows included.
        Changes changes;
        bool isDone = false;
    };

    SettingsFile(QString path, std::chrono::milliseconds patience);

    /// None where the disk does not answer in time. No settings where it is not an ordinary file, or too large.
    [[nodiscard]] std::optional<Content> read() const;
    /// Puts the changes into the file as it is at the time of writing; returns at once. Replaces changes that still
    /// wait, so `changes` must hold all that is not known to be written. `isClearing`: all other keys are removed.
    void write(Changes changes, bool isClearing);
    /// Waits until everything is written or has failed. False where the disk has not answered for as long as it is
    /// waited for: then it returns at once until it answers, and what was to be written is written when it does.
    [[nodiscard]] bool finish() const;
    /// The result of the last write; given once.
    [[nodiscard]] std::optional<Written> takeWritten();

private:
    struct Shared;

    static void work(Shared& shared);

    std::chrono::milliseconds m_patience;
    std::shared_ptr<Shared> m_shared;
};

} // namespace hairpaint::app
