// What is edited: the document's active group, map and layer.
#pragma once

#include "model/document/document.h"

#include <QObject>

#include <vector>

namespace hairpaint::view {

/// Not undone; follows the document if the active group or layer is deleted, or undo and imports change texels
/// elsewhere. Each setter returns false and emits nothing if nothing differs. GUI thread.
class EditTarget : public QObject
{
    Q_OBJECT
public:
    explicit EditTarget(model::Document& document, QObject* parent = nullptr);

    [[nodiscard]] model::Document& document() const { return m_document; }

    [[nodiscard]] model::Id group() const { return m_group; }
    bool setGroup(model::Id group);
    [[nodiscard]] model::MapKind map() const { return m_map; }
    bool setMap(model::MapKind map);
    /// The layer that tools paint on in the active map; kept per group and map; 0 where the map has none.
    [[nodiscard]] model::Id layer() const { return layer(m_map); }
    [[nodiscard]] model::Id layer(model::MapKind map) const; ///< The layer that tools paint on in any map.
    bool setLayer(model::Id layer);
    [[nodiscard]] model::LayerAddress address() const;
    /// The active group's settings; those of a new group where there is none.
    [[nodiscard]] const sim::GroupSettings& settings() const;
    /// The same; null where there is no active group.
    [[nodiscard]] const sim::GroupSettings* knownSettings() const;

    /// Why nothing can be painted on the active map, or on that one; empty where it can be.
    [[nodiscard]] QString refusal() const;
    [[nodiscard]] QString refusal(model::MapKind map) const;
    /// refusal() for a map that is not the active one, with the map's name before it.
    [[nodiscard]] QString refusalOfOther(model::MapKind map) const;

    /// While held it does not follow changed texels, since a tool paints where the user looks. Returns the previous
    /// state.
    bool hold(bool held);

Q_SIGNALS:
    void aboutToChange(); ///< A setter is about to change it: edits that are open on the old target end.
    void mapChosen();     ///< By setMap, also where that map was active before.
    /// The ranges of the active group may have changed; `told`: by a change to the group of which the user is told.
    void rangesChanged(bool told);
    void changed();

private:
    void onDocumentChanged(const model::Change& change);
    /// Activates the map that an undone or redone step changed last, unless the shown one is among those that it
    /// changed.
    void followStep();

    model::Document& m_document;
    model::Id m_group = 0;
    model::MapKind m_map = model::MapKind::Length;
    std::vector<model::LayerAddress> m_layers; ///< One for each group and map that was ever active.
    std::vector<model::Change> m_stepped;      ///< Texels that the unfinished step has changed.
    bool m_held = false;
};

} // namespace hairpaint::view
