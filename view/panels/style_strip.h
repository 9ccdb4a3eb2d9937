// Hairstyles side by side: pointing at one shows it on the head, clicking keeps it.
#pragma once

#include "model/error.h"
#include "model/files/preset_file.h"
#include "model/preset.h"
#include "view/editor_state.h"

#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>

class QHBoxLayout;
class QScrollArea;

namespace hairpaint::view {

class StyleTile;

/// 132 px high. Files are read in the background; the last few stay in memory. Built-in ones come first, then the
/// user's own, then "Save style".
class StyleStrip : public QWidget
{
    Q_OBJECT
public:
    using Loader = std::function<model::Result<model::Preset>(const QString& path)>;

    /// Has `load` run, which takes a while, and tells `done` on this thread, unless `receiver` is gone by then. What
    /// `load` throws becomes an error that names `doing`.
    using Start = std::function<void(const QString& doing, const std::function<model::Result<model::Preset>()>& load,
                                     QObject* receiver, const std::function<void(model::Result<model::Preset>)>& done)>;

    /// `loader` is called wherever `start` runs it.
    StyleStrip(EditorState& state, Loader loader, Start start, QWidget* parent = nullptr);

    void setEntries(const std::vector<model::PresetEntry>& entries);
    [[nodiscard]] std::vector<QString> paths() const;

public Q_SLOTS:
    void setPicture(const QString& path, const QImage& picture);

Q_SIGNALS:
    void saveStyleRequested();
    void renameStyleRequested(const QString& path); ///< Of the user's own ones, from the context menu.
    void deleteStyleRequested(const QString& path);
    void pictureWanted(const QString& path); ///< For each entry that has none.
    void failed(const QString& message);     ///< A style could not be read.

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    using PresetPtr = std::shared_ptr<const model::Preset>;
    void addTile(StyleTile* tile, const QImage& picture);
    [[nodiscard]] StyleTile* tile(const QString& path) const;
    void wish(const QString& path, bool commit);
    void loaded(const QString& path, model::Result<model::Preset> read);
    void arrived(const QString& path, const PresetPtr& preset);
    void preview(const PresetPtr& preset);
    void showStyle(const PresetPtr& preset);
    void apply(const PresetPtr& preset);
    void endPreview();
    void restoreTarget(); ///< Whoever ended the preview.

    EditorState& m_state;
    Loader m_loader;
    Start m_start;
    QScrollArea* m_scroll = nullptr;
    QHBoxLayout* m_row = nullptr;
    std::vector<StyleTile*> m_tiles;
    QTimer m_pause{this}; ///< Between pointing at a style and showing it.
    QString m_hovered;
    QString m_toCommit;
    model::EditSession m_edit;                   ///< Of the style that is shown.
    std::optional<model::LayerAddress> m_before; ///< What was active before, while a style is shown.
    std::vector<std::pair<QString, PresetPtr>> m_recent;
    std::vector<QString> m_loading;
};

} // namespace hairpaint::view
