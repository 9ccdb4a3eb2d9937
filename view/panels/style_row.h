// The pictures of styles side by side.
#pragma once

#include "view/panels/style_menu.h"

#include <QPoint>
#include <QScrollArea>
#include <QTimer>

#include <optional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace hairpaint::view {

class StyleTile;

/// Scrolls; tells at which one people point and which they take. A single tile takes Tab, arrows, Home and End go from
/// one to the next. Where none is shown, a sentence with a button stands there. GUI thread.
class StyleRow : public QScrollArea
{
    Q_OBJECT
public:
    explicit StyleRow(QWidget* parent);

    /// Replaces all that were there; the keys stay with the style that had them. Nothing is shown yet.
    void setTiles(const std::vector<StyleTile*>& tiles);
    [[nodiscard]] const std::vector<StyleTile*>& tiles() const { return m_tiles; }
    [[nodiscard]] StyleTile* tile(const QString& path) const; ///< Null where there is none.
    void showOnly(const std::vector<QString>& paths);         ///< In that order.
    [[nodiscard]] std::vector<QString> shownPaths() const;
    /// Instead of tiles; without `button` there is no button.
    void showSign(const QString& sentence, const QString& button);
    bool takeKeys(); ///< Gives the focus to the tile that had it last. False where none is shown.
    /// A style that the wheel brought under the resting pointer is pointed at from now on; a pause of the wheel calls
    /// it, and touch pads that tell of the end.
    void endScrolling();

Q_SIGNALS:
    void pointedAt(const QString& path);
    void rested(const QString& path); ///< Moved under the pointer, and at rest.
    void pointerLeft(const QString& path);
    void moved(); ///< The pictures, below the pointer.
    void chosen(const QString& path, Qt::KeyboardModifiers modifiers);
    void menuWanted(hairpaint::view::StyleTile* tile, const QPoint& globalPosition);
    void favouriteWanted(const QString& path, bool favourite);
    void ordered(const QString& path, hairpaint::view::StyleOrder order);
    void upWanted(); ///< By the key, from a tile.
    void signButtonClicked();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow(StyleTile* tile);
    void wheel(const class QWheelEvent& event);
    void contentMoved();
    void pointAt(const QString& path);
    void stopResting();
    [[nodiscard]] bool isResting() const;
    [[nodiscard]] bool moveKeys(const StyleTile* from, int key);
    void letTabStopAt(StyleTile* tile);

    QHBoxLayout* m_row = nullptr;
    QWidget* m_sign = nullptr;
    QLabel* m_sentence = nullptr;
    QPushButton* m_signButton = nullptr;
    std::vector<StyleTile*> m_tiles, m_shown;
    QTimer m_wheelPause{this};         ///< Between the wheel's last turn and its end.
    std::optional<QPoint> m_restingAt; ///< The pointer, when pictures last moved below it.
};

} // namespace hairpaint::view
