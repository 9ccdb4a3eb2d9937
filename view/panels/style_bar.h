// What stands over the pictures of styles: folders, what a click takes, and a search.
#pragma once

#include "model/styles/style_folder.h"
#include "model/styles/style_use.h"

#include <QWidget>

class QComboBox;
class QLineEdit;
class QTabBar;

namespace hairpaint::view {

class BarSlider;

/// A tab a folder, or a box of them where tabs have no room, in the order of model::styleFolders(). In the search Down
/// or Return goes on to the pictures, Esc empties it. GUI thread.
class StyleBar : public QWidget
{
    Q_OBJECT
public:
    explicit StyleBar(QWidget* parent);

    [[nodiscard]] const model::StyleFolder& folder() const;
    [[nodiscard]] QString words() const;         ///< Searched for; empty: all.
    [[nodiscard]] model::StylePart part() const; ///< What a click or Return on a picture takes.
    [[nodiscard]] double fraction() const;       ///< 0..1: as in model::StyleUse.
    void widen();                                ///< The same words in all folders; there, no words.
    void startSearch();                          ///< Gives the search the keys.
    void takeKeys();                             ///< Gives the folders the keys.

Q_SIGNALS:
    void filterChanged();
    void partChosen();
    void fractionMoved();     ///< By the user, who goes on,
    void fractionSet();       ///< and lets go,
    void fractionTakenBack(); ///< or takes it back.
    void downWanted();        ///< By the key, to the pictures.

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QTabBar* m_folders = nullptr;
    QComboBox* m_folderBox = nullptr; ///< The same folders.
    QComboBox* m_part = nullptr;
    BarSlider* m_fraction = nullptr;
    QLineEdit* m_search = nullptr;
};

} // namespace hairpaint::view
