// Hairstyles side by side: pointing at one shows it on the head, clicking keeps it.
#pragma once

#include "model/styles/style_use.h"
#include "view/editing/editor_state.h"
#include "view/panels/style_list.h"
#include "view/panels/style_menu.h"
#include "view/panels/style_shelf.h"

#include <QPoint>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>

namespace hairpaint::view {

class StyleBar;
class StyleFitting;
class StyleNotice;
class StyleQuestion;
class StyleRow;
class StyleTile;

/// 164 px high: folders and a search over pictures. Files are read in the background. Built-in ones come first, then
/// the user's own, then "Save style".
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

    void setMarks(const StyleMarks& marks);
    void setEntries(const std::vector<model::PresetEntry>& entries);
    [[nodiscard]] std::vector<QString> paths() const;      ///< All of them.
    [[nodiscard]] std::vector<QString> shownPaths() const; ///< Those of the folder that are found.
    void startSearch();                                    ///< Gives the search the keys.

public Q_SLOTS:
    void setPicture(const QString& path, const QImage& picture);
    void choose(const QString& path);        ///< As if its picture were clicked.
    void offerUndo(const QString& sentence); ///< Over the foot of the strip; an empty sentence takes it away.
    /// As if it were one of the strip's and clicked; it is on this head already.
    void putOn(const hairpaint::view::PresetPtr& preset);

Q_SIGNALS:
    void saveStyleRequested();
    void undoWanted(); ///< What offerUndo() tells is to be undone.
    void ordered(const QString& path, hairpaint::view::StyleOrder order);
    void marksChanged(const hairpaint::view::StyleMarks& marks); ///< The user changed them.
    void pictureWanted(const QString& path);                     ///< For each entry that has none.
    void failed(const QString& message);                         ///< A style could not be read, or does not fit.
    void asking();                                               ///< The strip must be seen now.

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
    [[nodiscard]] StyleTile* makeTile(const model::PresetEntry& entry);
    void followRow();
    void filter();
    void showMenu(StyleTile* tile, const QPoint& globalPosition);
    void pointAt(const QString& path);
    void pointAt(const Wish& wish);
    void contentMoved();
    [[nodiscard]] model::StylePart partOf(Qt::KeyboardModifiers modifiers) const;
    void setFavourite(const QString& path, bool favourite);
    void commitWish(const Wish& wish);
    void arrived(const QString& path, const PresetPtr& preset);
    void apply(const PresetPtr& preset, model::StylePart part);
    void stopPointing();
    void endPreview();

    EditorState& m_state;
    StyleShelf m_shelf;
    StyleList m_list;
    StyleRow* m_row = nullptr;
    StyleBar* m_bar = nullptr;
    StyleNotice* m_notice = nullptr;
    StyleQuestion* m_question = nullptr;
    /// The last one shown. It stays: what is chosen asks in dialogs while the menu's own event is still under way.
    std::unique_ptr<StyleMenu> m_menu;
    StyleFitting* m_fitting = nullptr;
    QTimer m_pause{this}; ///< Between pointing at a style and showing it.
    std::optional<Wish> m_pointed, m_toCommit;
    QString m_putOn; ///< The path of what was put on last; none: it is none of the strip's.
};

} // namespace hairpaint::view
