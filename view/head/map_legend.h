// What the colours on the hair mean while one map is looked at.
#pragma once

#include "model/map_spec.h"
#include "sim/groom/group_settings.h"

#include <QWidget>

namespace hairpaint::view {

/// A card over the 3D area; lets every pointer event through.
class MapLegend : public QWidget
{
    Q_OBJECT
public:
    explicit MapLegend(QWidget* parent);

    /// Stands in the parent's lower left corner.
    void showMap(const model::MapSpec& spec, const sim::GroupSettings& settings);
    /// "Length" and "0–30 cm", or the names of an index map's colours.
    [[nodiscard]] const QString& title() const { return m_title; }
    [[nodiscard]] const QStringList& labels() const { return m_labels; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_title;
    QStringList m_labels;
    QList<QColor> m_colours; ///< Of a scale from 0 to 1, or one for each label.
    bool m_isScale = false;
};

} // namespace hairpaint::view
