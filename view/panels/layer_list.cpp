// The list of layers.
#include "view/panels/layer_list.h"

#include "view/panels/layer_item.h"

#include <QDropEvent>
#include <QKeyEvent>
#include <QMouseEvent>

namespace hairpaint::view {

LayerList::LayerList(Rows rows, QWidget* parent) : QListWidget(parent), m_rows(rows)
{
    setSelectionMode(QAbstractItemView::SingleSelection);
    setDragDropMode(QAbstractItemView::InternalMove);
    setDefaultDropAction(Qt::MoveAction);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setUniformItemSizes(true);
    setMouseTracking(true);
    setMinimumHeight(2 * rowHeight() + 2);
    auto* painter = new LayerItem(this);
    setItemDelegate(painter);
    connect(painter, &LayerItem::renamed, this,
            [this](const QModelIndex& index, const QString& name) { Q_EMIT renameWanted(idAt(index.row()), name); });
}

model::Id LayerList::idAt(int row) const
{
    const QListWidgetItem* found = item(row);
    return found != nullptr ? found->data(IdRole).toInt() : 0;
}

QRect LayerList::eyeRect(const QRect& row)
{
    return {row.left() + 6, row.top(), 24, row.height()};
}

QRect LayerList::lockRect(const QRect& row)
{
    return {row.right() - 28, row.top(), 26, row.height()};
}

bool LayerList::onEye(QPoint position) const
{
    const QListWidgetItem* under = itemAt(position);
    return under != nullptr && eyeRect(visualItemRect(under)).contains(position);
}

bool LayerList::onLock(QPoint position) const
{
    const QListWidgetItem* under = itemAt(position);
    return m_rows == Rows::Layers && under != nullptr && lockRect(visualItemRect(under)).contains(position);
}

void LayerList::mousePressEvent(QMouseEvent* event)
{
    const QPoint position = event->position().toPoint();
    const QListWidgetItem* under = itemAt(position);
    if (event->button() == Qt::LeftButton && onEye(position))
        Q_EMIT visibleWanted(under->data(IdRole).toInt(), !under->data(VisibleRole).toBool());
    else if (event->button() == Qt::LeftButton && onLock(position))
        Q_EMIT lockWanted(under->data(IdRole).toInt(), !under->data(LockedRole).toBool());
    else
        QListWidget::mousePressEvent(event);
}

void LayerList::mouseReleaseEvent(QMouseEvent* event)
{
    const QPoint position = event->position().toPoint();
    if (!onEye(position) && !onLock(position))
        QListWidget::mouseReleaseEvent(event);
}

void LayerList::mouseDoubleClickEvent(QMouseEvent* event)
{
    const QPoint position = event->position().toPoint();
    if (onEye(position) || onLock(position))
        mousePressEvent(event);
    else
        QListWidget::mouseDoubleClickEvent(event);
}

QItemSelectionModel::SelectionFlags LayerList::selectionCommand(const QModelIndex& index, const QEvent* /*event*/) const
{
    return index.isValid() ? QItemSelectionModel::ClearAndSelect : QItemSelectionModel::NoUpdate;
}

void LayerList::keyPressEvent(QKeyEvent* event)
{
    const QListWidgetItem* current = currentItem();
    if (current != nullptr && state() != EditingState) {
        const model::Id layer = current->data(IdRole).toInt();
        if (event->key() == Qt::Key_Delete) {
            Q_EMIT removeWanted();
            return;
        }
        if (event->key() == Qt::Key_Space) {
            Q_EMIT visibleWanted(layer, !current->data(VisibleRole).toBool());
            return;
        }
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
            editItem(currentItem());
            return;
        }
        if ((event->modifiers() & Qt::AltModifier) != 0 &&
            (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down)) {
            const int wanted = row(current) + (event->key() == Qt::Key_Up ? -1 : 1);
            if (wanted >= 0 && wanted < count())
                Q_EMIT moveWanted(layer, wanted);
            return;
        }
    }
    QListWidget::keyPressEvent(event);
}

bool LayerList::dropAt(QPoint position)
{
    QListWidgetItem* dragged = currentItem();
    if (dragged == nullptr)
        return false;
    const int from = row(dragged);
    int to = count();
    if (const QListWidgetItem* under = itemAt(position)) {
        const QRect rect = visualItemRect(under);
        to = row(under) + (position.y() > rect.center().y() ? 1 : 0);
    }
    if (to > from)
        --to;
    if (to == from)
        return false;
    Q_EMIT moveWanted(dragged->data(IdRole).toInt(), to);
    return true;
}

void LayerList::dropEvent(QDropEvent* event)
{
    if (event->source() != this) {
        event->ignore();
        return;
    }
    // The document moves the layer and the rows follow it; nothing is moved here.
    event->setDropAction(Qt::IgnoreAction);
    event->accept();
    dropAt(event->position().toPoint());
}

} // namespace hairpaint::view
