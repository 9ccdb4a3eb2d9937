// What both areas show besides head and hair, and whether they work mirrored.
#pragma once

#include "model/document/document.h"

#include <QObject>

#include <cstddef>
#include <optional>

namespace hairpaint::view {

/// Outside undo. Each setter returns false and tells nothing where nothing differs. GUI thread.
class ViewOptions : public QObject
{
    Q_OBJECT
public:
    explicit ViewOptions(const model::Document& document, QObject* parent = nullptr)
        : QObject(parent), m_document(document)
    {}

    /// What is done on one side of the head is done on the other, too.
    [[nodiscard]] bool mirror() const { return m_mirror; }
    bool setMirror(bool mirror) { return set(m_mirror, mirror); }
    [[nodiscard]] bool nightPaper() const { return m_nightPaper; }
    bool setNightPaper(bool night) { return set(m_nightPaper, night); }
    [[nodiscard]] bool wireframe() const { return m_wireframe; }
    bool setWireframe(bool shown) { return set(m_wireframe, shown); }
    /// The project's ellipsoids over the head.
    [[nodiscard]] bool collidersShown() const { return m_collidersShown; }
    bool setCollidersShown(bool shown) { return set(m_collidersShown, shown); }
    /// The one of them that is edited; none while they are not shown.
    [[nodiscard]] std::optional<std::size_t> chosenCollider() const
    {
        const bool there = m_chosenCollider && *m_chosenCollider < m_document.project().ellipsoids.size();
        return there && m_collidersShown ? m_chosenCollider : std::nullopt;
    }
    bool setChosenCollider(std::optional<std::size_t> index) { return set(m_chosenCollider, index); }
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
    std::optional<std::size_t> m_chosenCollider;
    bool m_directionsShown = true;
};

} // namespace hairpaint::view
