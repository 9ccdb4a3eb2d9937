// Hairstyles side by side: pointing at one shows it on the head, clicking keeps it.
#pragma once

#include "model/files/preset_file.h"
#include "model/styles/style_use.h"
#include "view/editing/editor_state.h"
#include "view/panels/style_shelf.h"

#include <QPoint>
#include <QTimer>
#include <QWidget>

#include <optional>

class QHBoxLayout;
class QScrollArea;

namespace hairpaint::view {

class StyleFitting;
class StyleQuestion;
class StyleTile;

/// 132 px high. Files are read in the background. Built-in ones come first, then the user's own, then "Save style".
/// A click replaces the groups that a style is about; where it is not evidently about one, the strip asks. What is
/// shown while a style is pointed at is what a click would do.
class StyleStrip : public QWidget
{
    Q_OBJECT
public:
    using Loader = StyleShelf::Loader;
    using Start = StyleShelf::Start;

    /// `loader` is called wherever `start` runs it.
    StyleStrip(EditorState& state, Loader loader, Start start, QWidget* parent = nullptr);

    void setEntries(const std::vector<model::PresetEntry>& entries);
    [[nodiscard]] std::vector<QString> paths() const;

public Q_SLOTS:
    void setPicture(const QString& path, const QImage& picture);
    /// As if it were one of the strip's and clicked; it is on this head already.
    void putOn(const hairpaint::view::PresetPtr& preset);
    /// A style that the wheel brought under the resting pointer is pointed at from now on; a pause of the wheel calls
    /// it, and touch pads that tell of the end.
    void endScrolling();

Q_SIGNALS:
    void saveStyleRequested();
    void renameStyleRequested(const QString& path); ///< Of the user's own ones, from the context menu.
    void deleteStyleRequested(const QString& path);
    void pictureWanted(const QString& path); ///< For each entry that has none.
    void failed(const QString& message);     ///< A style could not be read, or does not fit.
    void asking();                           ///< The strip must be seen now.

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    /// A style, or a part of it.
    struct Wish
    {
        QString path;
        model::StylePart part = model::StylePart::All;
    };
    void addTile(StyleTile* tile, const QImage& picture);
    void followTile(StyleTile* tile);
    void showMenu(StyleTile* tile, const QPoint& globalPosition);
    [[nodiscard]] StyleTile* tile(const QString& path) const;
    void pointAt(const QString& path);
    void pointAt(const Wish& wish);
    void contentMoved();
    void wheel(const class QWheelEvent& event);
    void commitWish(const Wish& wish);
    void arrived(const QString& path, const PresetPtr& preset);
    void apply(const PresetPtr& preset, model::StylePart part);
    void stopPointing();
    void endPreview();

    EditorState& m_state;
    StyleShelf m_shelf;
    QScrollArea* m_scroll = nullptr;
    QHBoxLayout* m_row = nullptr;
    StyleQuestion* m_question = nullptr;
    StyleFitting* m_fitting = nullptr;
    std::vector<StyleTile*> m_tiles;
    QTimer m_pause{this};              ///< Between pointing at a style and showing it.
    QTimer m_wheelPause{this};         ///< Between the wheel's last turn and its end.
    std::optional<QPoint> m_restingAt; ///< The pointer, when pictures last moved below it.
    std::optional<Wish> m_pointed, m_toCommit;
};

} // namespace hairpaint::view
