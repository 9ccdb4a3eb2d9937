// One map in the maps panel: letter and icon, name, range, thumbnail.
#pragma once

#include "model/project/map_spec.h"

#include <QAbstractButton>
#include <QImage>

namespace hairpaint::view {

class MapRow : public QAbstractButton
{
    Q_OBJECT
public:
    explicit MapRow(model::MapKind map, QWidget* parent = nullptr);
    /// `size`: texels a side, 0 where there is no map.
    void setRange(const QString& range, int size);
    void setThumbnail(const QImage& thumbnail);
    [[nodiscard]] QSize sizeHint() const override { return {220, 28}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {220, kThumbnailSide + 1}; }
    static constexpr int kThumbnailSide = 24;
    static constexpr int kDigits = 10; ///< Keys that choose a map: 1 to 9, then 0.

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    model::MapKind m_map;
    QString m_range;
    QString m_rangeAndSize;
    QImage m_thumbnail;
};

} // namespace hairpaint::view
