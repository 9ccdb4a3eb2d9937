// The prims of a USD stage, composed of its layers (openusd.org, "LIVERPS strength ordering").
#pragma once

#include "model/importing/usd_specs.h"

#include <QStringList>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace hairpaint::model {

/// A layer and its sublayers, the strongest first.
using UsdLayerStack = std::vector<const UsdText*>;

/// A prim: what one stack of layers says of it, and below that the arcs to others that it is made of.
struct UsdPrim
{
    struct Spec
    {
        const UsdSpec* spec = nullptr;
        const UsdText* layer = nullptr; ///< That holds it.
    };

    const UsdLayerStack* stack = nullptr;
    std::vector<Spec> specs;   ///< The strongest first.
    std::vector<UsdPrim> arcs; ///< Weaker than the specs, the strongest first.
    UsdArc arc = UsdArc::References;
    int depth = 0;            ///< Of arcs.
    bool isAncestral = false; ///< The arc is that of a prim above.

    /// visit(spec) for each, the strongest first, until it returns false. Returns whether it went through.
    template<typename Visit>
    bool eachSpec(const Visit& visit) const
    {
        for (const Spec& own : specs)
            if (!visit(*own.spec))
                return false;
        for (const UsdPrim& other : arcs)
            if (!other.eachSpec(visit))
                return false;
        return true;
    }

    /// As the strongest opinion has it; empty where there is none.
    [[nodiscard]] std::string_view type() const;
    [[nodiscard]] bool isActive() const;
    /// Some layer defines it, and it is no class.
    [[nodiscard]] bool isDefined() const;
    [[nodiscard]] UsdOpinion attribute(std::string_view name) const;
    /// Of its attributes.
    [[nodiscard]] std::vector<std::string_view> namesWith(std::string_view prefix) const;
    /// Of its children; the strongest layer's first.
    [[nodiscard]] std::vector<std::string_view> children() const;
};

class UsdStage
{
public:
    enum class Problem : std::uint8_t
    {
        None,
        Broken,
        Stopped
    };

    /// `progress`: while text is scanned.
    UsdStage(UsdOpener opener, Progress progress) : m_opener(std::move(opener)), m_progress(std::move(progress)) {}

    /// Above all prims; its layer tells unit and axis. Its specs are none where there is a problem.
    [[nodiscard]] UsdPrim root(const QByteArray& text);
    /// A composed prim's child, composed. It may have no spec.
    [[nodiscard]] UsdPrim child(const UsdPrim& parent, std::string_view name);
    [[nodiscard]] Problem problem() const { return m_problem; }
    /// What was named and not read: files, and prims that name themselves.
    [[nodiscard]] const QStringList& unread() const { return m_unread; }

private:
    [[nodiscard]] const UsdText* open(const QString& asset, const UsdText& from);
    [[nodiscard]] const UsdText* scan(UsdLayer layer);
    [[nodiscard]] const UsdLayerStack& stackOf(const UsdText& text);
    void addLayers(UsdLayerStack& stack, const UsdText& text);
    [[nodiscard]] UsdPrim rootOf(const UsdLayerStack& stack, int depth);
    [[nodiscard]] UsdPrim childOf(const UsdPrim& parent, std::string_view name);
    void addArcs(UsdPrim& prim);
    void follow(UsdPrim& prim, UsdArc arc, const UsdReference& reference, const UsdText& from);
    void chooseVariants(UsdPrim& prim);
    bool chooseVariant(UsdPrim& prim, const UsdPrim& whole);
    void leave(const UsdReference& reference);
    [[nodiscard]] bool goesOn() const { return m_problem == Problem::None; }

    UsdOpener m_opener;
    Progress m_progress;
    std::vector<std::unique_ptr<UsdText>> m_texts;
    std::map<std::pair<const UsdText*, QString>, const UsdText*> m_opened; ///< By who names it; null: not read.
    std::map<const UsdText*, std::unique_ptr<UsdLayerStack>> m_stacks;
    std::size_t m_scanned = 0; ///< Prims.
    std::size_t m_made = 0;    ///< Nodes of composed prims.
    std::size_t m_followed = 0;
    QStringList m_unread;
    Problem m_problem = Problem::None;
};

} // namespace hairpaint::model
