// What can be done with a style, as its picture's menu offers it.
#pragma once

#include "model/styles/style_use.h"

#include <QKeySequence>
#include <QMenu>

#include <cstdint>
#include <span>

namespace hairpaint::view {

/// What the program is to do with a style's file.
enum class StyleOrder : std::uint8_t
{
    About, ///< Shows its card.
    Rename,
    Tag,
    Replace, ///< Replaces it by the hair that is open.
    Picture, ///< Draws its picture anew from where the 3D area is looked at.
    Export,
    Delete
};

/// A row of the table of orders. Keys count on a picture that has the keys.
struct StyleOrderSpec
{
    StyleOrder order;
    const char* title;                       ///< To be translated in context "StyleOrders".
    QKeyCombination key = {};                ///< None: Qt::Key{}.
    bool ofOwn = true;                       ///< Only for the user's own styles.
    [[nodiscard]] QString titleText() const; ///< Translated.
};
[[nodiscard]] std::span<const StyleOrderSpec> styleOrders();
inline constexpr QKeyCombination kFavouriteKey = Qt::CTRL | Qt::Key_D;

/// Parts to put on, the mark of a favourite, and orders. GUI thread.
class StyleMenu : public QMenu
{
    Q_OBJECT
public:
    StyleMenu(bool own, bool favourite, QWidget* parent);

Q_SIGNALS:
    void partPointedAt(hairpaint::model::StylePart part);
    void partChosen(hairpaint::model::StylePart part);
    void favouriteWanted(bool favourite);
    void ordered(hairpaint::view::StyleOrder order);
};

} // namespace hairpaint::view
