// Paints one row of the layer list.
#include "view/panels/layer_item.h"

#include "view/look/icons.h"
#include "view/look/theme.h"
#include "view/panels/layer_list.h"

#include <QLineEdit>
#include <QPainter>
#include <QPainterPath>

namespace hairpaint::view {

namespace {

QRect thumbnailRect(const QRect& row)
{
    const int side = LayerList::kThumbnailSide;
    return {LayerList::eyeRect(row).right() + metrics::kGrid, row.top() + (row.height() - side) / 2, side, side};
}

QRect nameRect(const QRect& row, bool layers)
{
    const int left = layers ? thumbnailRect(row).right() + metrics::kGap : LayerList::eyeRect(row).right() + 6;
    const int right = layers ? LayerList::lockRect(row).left() : row.right();
    return {left, row.top(), right - left - metrics::kGrid, row.height()};
}

bool showsLayers(const QStyleOptionViewItem& option)
{
    const auto* list = qobject_cast<const LayerList*>(option.widget);
    return list == nullptr || list->rows() == LayerList::Rows::Layers;
}

void paintThumbnail(QPainter& painter, const QRect& rect, const QImage& picture, const Theme& theme)
{
    QPainterPath frame;
    frame.addRoundedRect(QRectF(rect), 3.0, 3.0);
    painter.save();
    painter.setClipPath(frame);
    // A quiet chequer tells "nothing here" from black.
    painter.fillRect(rect, theme.panel);
    for (int y = 0; y < rect.height(); y += 7)
        for (int x = (y / 7 % 2) * 7; x < rect.width(); x += 14)
            painter.fillRect(QRect(rect.left() + x, rect.top() + y, 7, 7), theme.raised);
    if (!picture.isNull())
        painter.drawImage(rect, picture);
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.line, 1.0));
    painter.drawPath(frame);
}

} // namespace

QSize LayerItem::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const
{
    const auto* list = qobject_cast<const LayerList*>(option.widget);
    return {160, list != nullptr ? list->rowHeight() : metrics::kRow};
}

void LayerItem::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const Theme theme = Theme::current();
    const bool selected = (option.state & QStyle::State_Selected) != 0;
    const bool hover = (option.state & QStyle::State_MouseOver) != 0;
    const bool layers = showsLayers(option);
    const bool visible = index.data(LayerList::VisibleRole).toBool();
    const bool locked = index.data(LayerList::LockedRole).toBool();
    const qreal ratio = painter->device()->devicePixelRatioF();
    painter->save();
    painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    if (selected || hover)
        painter->fillRect(option.rect, selected ? theme.raised : theme.panel);
    if (selected)
        painter->fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())), theme.accent);

    const auto drawIcon = [&](const QRect& rect, const QString& name, const QColor& colour) {
        painter->drawPixmap(QPoint(rect.center().x() - 8, rect.center().y() - 8), iconPixmap(name, 18, colour, ratio));
    };
    drawIcon(LayerList::eyeRect(option.rect), visible ? QStringLiteral("visible") : QStringLiteral("hidden"),
             visible ? theme.text : theme.dimText);
    if (layers && (locked || selected || hover))
        drawIcon(LayerList::lockRect(option.rect), locked ? QStringLiteral("lock") : QStringLiteral("unlock"),
                 locked ? theme.text : theme.dimText);
    if (layers) {
        painter->setOpacity(visible ? 1.0 : 0.45);
        paintThumbnail(*painter, thumbnailRect(option.rect), index.data(LayerList::ThumbnailRole).value<QImage>(),
                       theme);
        painter->setOpacity(1.0);
    }
    QFont font = themeFont(TextRole::Body);
    if (selected)
        font.setWeight(QFont::DemiBold);
    painter->setFont(font);
    painter->setPen(visible ? theme.text : theme.dimText);
    const QRect name = nameRect(option.rect, layers);
    painter->drawText(
        name, Qt::AlignLeft | Qt::AlignVCenter,
        painter->fontMetrics().elidedText(index.data(Qt::DisplayRole).toString(), Qt::ElideRight, name.width()));
    painter->restore();
}

void LayerItem::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                     const QModelIndex& /*index*/) const
{
    editor->setGeometry(nameRect(option.rect, showsLayers(option)).adjusted(-6, 2, 0, -2));
}

void LayerItem::setModelData(QWidget* editor, QAbstractItemModel* /*model*/, const QModelIndex& index) const
{
    const auto* field = qobject_cast<QLineEdit*>(editor);
    if (field == nullptr)
        return;
    const QString name = field->text().trimmed();
    if (!name.isEmpty() && name != index.data(Qt::DisplayRole).toString())
        Q_EMIT renamed(index, name);
}

} // namespace hairpaint::view
