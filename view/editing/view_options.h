// What both areas show besides head and hair, and whether edits are mirrored.
#pragma once

#include "model/document/document.h"

#include <QObject>

namespace hairpaint::view {

/// Not undone. Each setter returns false and emits nothing if nothing differs. GUI thread.
class ViewOptions : public QObject
{
    Q_OBJECT
public:
    explicit ViewOptions(const model::Document& document, QObject* parent = nullptr)
        : QObject(parent), m_document(document)
    {}

    /// Edits on one side of the head are mirrored to the other.
    [[nodiscard]] bool mirror() const { return m_mirror; }
    bool setMirror(bool mirror) { return set(m_mirror, mirror); }
    [[nodiscard]] bool nightPaper() const { return m_nightPaper; }
    bool setNightPaper(bool night) { return set(m_nightPaper, night); }
    [[nodiscard]] bool wireframe() const { return m_wireframe; }
    bool setWireframe(bool shown) { return set(m_wireframe, shown); }
    /// The outlines of all that is worn, also of what is never drawn.
    [[nodiscard]] bool collidersShown() const { return m_collidersShown; }
    bool setCollidersShown(bool shown) { return set(m_collidersShown, shown); }
    /// The worn thing that is edited; 0: none, as while it is not seen.
    [[nodiscard]] model::Id chosenWorn() const
    {
        const model::Worn* worn = m_document.project().wornThing(m_chosenWorn);
        return worn != nullptr && (m_collidersShown || wornSpec(worn->kind).drawn()) ? m_chosenWorn : 0;
    }
    bool setChosenWorn(model::Id id) { return set(m_chosenWorn, id); }
    /// Short hairs on the head that tell the active direction map, while it is the active one.
    [[nodiscard]] bool directionsShown() const { return m_directionsShown; }
    bool setDirectionsShown(bool shown) { return set(m_directionsShown, shown); }

Q_SIGNALS:
    void changed();

private:
    template<typename Option>
    bool set(Option& option, Option value)
    {
        if (option == value)
            return false;
        option = value;
        Q_EMIT changed();
        return true;
    }

    const model::Document& m_document;
    bool m_mirror = true;
    bool m_nightPaper = true;
    bool m_wireframe = true;
    bool m_collidersShown = false;
    model::Id m_chosenWorn = 0;
    bool m_directionsShown = true;
};

} // namespace hairpaint::view
