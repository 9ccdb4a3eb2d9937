// Settings that are kept between runs.
#pragma once

#include "app/settings/settings_store.h"
#include "view/dialogs/picture_dialog.h"
#include "view/dialogs/preferences_dialog.h"
#include "view/panels/style_list.h"

#include <QByteArray>
#include <QKeySequence>
#include <QPoint>
#include <QStringList>

#include <optional>

namespace hairpaint::app {

/// Every value has a default. GUI thread.
class Settings
{
public:
    [[nodiscard]] view::Preferences preferences() const;
    void setPreferences(const view::Preferences& preferences);

    [[nodiscard]] QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);

    /// Newest first, at most ten.
    [[nodiscard]] QStringList recentFiles() const;
    void addRecentFile(const QString& path);
    void removeRecentFile(const QString& path);

    /// The folder in which file dialogs open.
    [[nodiscard]] QString lastFolder() const;
    void setLastFolder(const QString& folder);

    /// Whether the 3D area was ever turned by hand, so that nobody need be told how.
    [[nodiscard]] bool viewTurned() const;
    void setViewTurned();

    /// The author that exported avatars name.
    [[nodiscard]] QString avatarAuthor() const;
    void setAvatarAuthor(const QString& author);

    /// How pictures are saved.
    [[nodiscard]] view::PictureChoice pictureChoice() const;
    void setPictureChoice(const view::PictureChoice& choice);

    /// Favourites and what was put on last.
    [[nodiscard]] view::StyleMarks styleMarks() const;
    void setStyleMarks(const view::StyleMarks& marks);

    /// What a tool was set to (model::optionOf); none where it never was.
    [[nodiscard]] std::optional<double> toolOption(const QString& key) const;
    void setToolOption(const QString& key, double value);

    /// Where the user left a dialog, global px; none where it stays where it opens.
    [[nodiscard]] std::optional<QPoint> dialogPosition(const QString& dialog) const;
    void setDialogPosition(const QString& dialog, QPoint position);

    /// A rebound key; none where the default holds.
    [[nodiscard]] std::optional<QKeySequence> key(const QString& actionId) const;
    void setKey(const QString& actionId, const QKeySequence& key);
    void removeKey(const QString& actionId);

private:
    SettingsStore m_settings;
};

} // namespace hairpaint::app
