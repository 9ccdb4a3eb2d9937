// One style of the strip: its picture and name.
#pragma once

#include "view/panels/style_menu.h"

#include <QAbstractButton>
#include <QImage>

class QToolButton;

namespace hairpaint::view {

class StyleTile : public QAbstractButton
{
    Q_OBJECT
public:
    /// `path` empty: the tile that saves a style.
    StyleTile(const QString& path, const QString& name, bool own, QWidget* parent = nullptr);
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] bool own() const { return m_own; }
    void setPicture(const QImage& picture);
    [[nodiscard]] bool hasPicture() const { return !m_picture.isNull(); }
    void setBusy(bool busy);
    void setFavourite(bool favourite); ///< A star in the picture's corner.
    [[nodiscard]] bool isFavourite() const { return m_favourite; }
    void setShown(bool shown); ///< On the head, to be looked at.
    /// Now; Qt tells only of a pointer that moves, not of a tile that does.
    [[nodiscard]] bool isUnderPointer() const;
    void refresh(); ///< Its mark, after it has been moved.
    static constexpr int kPicture = 96;
    [[nodiscard]] QSize sizeHint() const override { return {kPicture + 4, kPicture + 24}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void entered(); ///< By the pointer, or because the strip was scrolled under it.
    void left();
    void pointerMoved();
    void chosen(Qt::KeyboardModifiers modifiers); ///< By mouse or key.
    void menuWanted(const QPoint& globalPosition);
    void favouriteWanted(bool favourite);            ///< By the star or its key.
    void ordered(hairpaint::view::StyleOrder order); ///< By key.

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    [[nodiscard]] bool isMarked() const;
    [[nodiscard]] bool takesKey(const QKeyEvent& event) const; ///< It is the favourites' or an order's.
    [[nodiscard]] QToolButton* addCornerButton(const QString& icon, int left);

    QToolButton* m_menu = nullptr;  ///< In the picture's corner, while the tile is pointed at or has the focus.
    QToolButton* m_star = nullptr;  ///< In the other corner; of a favourite always.
    QToolButton* m_about = nullptr; ///< Beside the menu's, with it.
    Qt::KeyboardModifiers m_modifiers;
    QString m_path;
    bool m_own;
    bool m_busy = false;
    bool m_shown = false;
    bool m_favourite = false;
    QImage m_picture;
};

} // namespace hairpaint::view
