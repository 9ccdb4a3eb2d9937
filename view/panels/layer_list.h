// The list of layers or groups: rows painted with eye, lock, thumbnail and name; reordered by dragging.
#pragma once

#include "model/project/project.h"

#include <QListWidget>

namespace hairpaint::view {

/// Rows hold the layer's (or group's) id in Qt::UserRole. The list never changes the document; it says what is wanted.
class LayerList : public QListWidget
{
    Q_OBJECT
public:
    enum Role
    {
        IdRole = Qt::UserRole,
        VisibleRole,
        LockedRole,
        ThumbnailRole
    };
    enum class Rows
    {
        Layers,
        Groups ///< No lock, no thumbnail.
    };
    explicit LayerList(Rows rows, QWidget* parent = nullptr);
    [[nodiscard]] Rows rows() const { return m_rows; }
    [[nodiscard]] int rowHeight() const { return m_rows == Rows::Layers ? 36 : 28; }
    [[nodiscard]] model::Id idAt(int row) const;
    static constexpr int kThumbnailSide = 28;
    /// Drops the current row at an index of the list; false where it stays.
    bool dropAt(QPoint position);
    /// Where the eye and the lock lie in a row.
    [[nodiscard]] static QRect eyeRect(const QRect& row);
    [[nodiscard]] static QRect lockRect(const QRect& row);

Q_SIGNALS:
    void visibleWanted(int layer, bool visible);
    void lockWanted(int layer, bool locked);
    void renameWanted(int layer, const QString& name);
    void moveWanted(int layer, int row); ///< To be in that row, counted from the top.
    void removeWanted();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    /// One is always the active one: clicks beside the rows, or with Ctrl on it, leave it so.
    [[nodiscard]] QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index,
                                                                       const QEvent* event) const override;

private:
    [[nodiscard]] bool onEye(QPoint position) const;
    [[nodiscard]] bool onLock(QPoint position) const;

    Rows m_rows;
};

} // namespace hairpaint::view
