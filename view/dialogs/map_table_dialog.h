// Which image goes to which map: what their names tell, to be corrected.
#pragma once

#include "model/project/map_spec.h"

#include <QDialog>

#include <optional>
#include <vector>

class QComboBox;

namespace hairpaint::view {

/// An image and the map that it goes to.
struct ImageForMap
{
    QString path;
    std::optional<model::MapKind> map; ///< None: it is left out.
    std::size_t group = 0;             ///< Its number in the list.
};

/// Modal.
class MapTableDialog : public QDialog
{
    Q_OBJECT
public:
    MapTableDialog(const std::vector<ImageForMap>& images, const QStringList& groupNames, QWidget* parent = nullptr);
    [[nodiscard]] std::vector<ImageForMap> choice() const;

private:
    struct Row
    {
        QString path;
        QComboBox* map = nullptr;
        QComboBox* group = nullptr;
    };
    std::vector<Row> m_rows;
};

} // namespace hairpaint::view
