// The legend of a map's colours, on the paint area and on hair that shows one map.
#pragma once

#include "model/project/map_spec.h"
#include "sim/groom/group_settings.h"

#include <QList>
#include <QVariantAnimation>
#include <QWidget>

namespace hairpaint::view {

/// A card over an area; lets every pointer event through, and fades while the pointer is near it, so that what lies
/// below can be seen and painted. In a small area it is folded to its title and its colours.
class MapLegend : public QWidget
{
    Q_OBJECT
public:
    explicit MapLegend(QWidget* parent);

    /// A mark on a scale's bar.
    struct Tick
    {
        double fraction = 0.0; ///< 0..1 along the bar, where model::shownFraction() puts the value.
        QString text;
    };

    /// Stands in the parent's lower left corner.
    void showMap(const model::MapSpec& spec, const sim::GroupSettings& settings, bool nightPaper = false);
    [[nodiscard]] bool faded() const { return m_faded; }
    [[nodiscard]] bool folded() const { return m_folded; }
    /// "Length" and "0–30 cm", or the names of an index map's colours.
    [[nodiscard]] const QString& title() const { return m_title; }
    [[nodiscard]] const QStringList& labels() const { return m_labels; }
    [[nodiscard]] const QList<Tick>& ticks() const { return m_ticks; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void setFaded(bool faded);
    void reposition(); ///< Moves to the parent's lower left corner, folded where the parent is small.
    void paintFolded(QPainter& painter, const QRect& line) const;
    void paintScale(QPainter& painter, const QRect& line) const;

    QString m_title;
    QStringList m_labels;
    QList<Tick> m_ticks;
    QList<QColor> m_colours; ///< A scale's first and last colour, or one for each label.
    bool m_isScale = false;
    bool m_folded = false;
    bool m_faded = false;
    QVariantAnimation m_fading{this};       ///< Its value is the card's opacity.
    const model::MapSpec* m_spec = nullptr; ///< The map that is shown, so that showing it again costs nothing.
    sim::GroupSettings m_settings;
    bool m_nightPaper = false;
};

} // namespace hairpaint::view
