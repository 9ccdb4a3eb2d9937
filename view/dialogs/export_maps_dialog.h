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
    Group, ///< All of the active group's.
    All
};

struct MapsExportChoice
{
    MapRange range = MapRange::Group;
    model::MapImageOptions options;
};

/// Modal. Nothing is written by it: when accepted, ask for choice().
class ExportMapsDialog : public QDialog
{
    Q_OBJECT
public:
    /// `map`, `group`: what the active ones are called.
    ExportMapsDialog(const QString& map, const QString& group, const MapsExportChoice& before,
                     QWidget* parent = nullptr);
    [[nodiscard]] MapsExportChoice choice() const;

private:
    [[nodiscard]] QComboBox* addChoice(QFormLayout& form, const QString& label, const QStringList& texts);
    void follow();

    QComboBox* m_range = nullptr;
    QComboBox* m_values = nullptr;
    QComboBox* m_format = nullptr;
    QComboBox* m_depth = nullptr;
};

} // namespace hairpaint::view
