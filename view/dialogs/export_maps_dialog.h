// Asks which maps are written as images, and how.
#pragma once

#include "model/exporting/map_images.h"

#include <QDialog>

#include <cstdint>

class QComboBox;
class QFormLayout;

namespace hairpaint::view {

/// Which maps are written.
enum class MapRange : std::uint8_t
{
    Active,
    Group, ///< All maps of the active group.
    All
};

struct MapsExportChoice
{
    MapRange range = MapRange::Group;
    model::MapImageOptions options;
};

/// What there is to choose from.
struct MapsToExport
{
    QString map;          ///< Name of the active map.
    QString group;        ///< Name of the active group.
    model::UvTiles tiles; ///< Tiles of the head's uv layout.
};

/// Modal. Nothing is written by it: when accepted, ask for choice().
class ExportMapsDialog : public QDialog
{
    Q_OBJECT
public:
    ExportMapsDialog(const MapsToExport& maps, const MapsExportChoice& before, QWidget* parent = nullptr);
    [[nodiscard]] MapsExportChoice choice() const;

private:
    [[nodiscard]] QComboBox* addChoice(QFormLayout& form, const QString& label, const QStringList& texts);
    void follow();

    model::UvTiles m_headTiles;
    QComboBox* m_range = nullptr;
    QComboBox* m_values = nullptr;
    QComboBox* m_tiles = nullptr; ///< Null where the head's layout was one of one tile.
    QComboBox* m_format = nullptr;
    QComboBox* m_depth = nullptr;
};

} // namespace hairpaint::view
