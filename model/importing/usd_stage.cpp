// Arcs followed from the prims above down, so that what is stronger stands first.
#include "model/importing/usd_stage.h"

#include <algorithm>
#include <set>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr std::size_t kMostLayers = 64;
constexpr qint64 kMostBytes = qint64{1} << 30; ///< Of all layers.
constexpr int kDeepestArcs = 8;
constexpr std::size_t kMostArcs = std::size_t{1} << 15U;
constexpr std::size_t kMostOpened = 4096; ///< Files, tried or read.
constexpr qsizetype kMostUnread = 64;
constexpr std::size_t kMostNodes = std::size_t{1} << 20U;

/// The edits of all layers of a stack as one list, each with the layer that names it.
std::vector<std::pair<UsdReference, const UsdText*>> listOf(const UsdPrim& prim, UsdArc arc)
{
    std::vector<std::pair<UsdReference, const UsdText*>> list;
    for (std::size_t weakest = prim.specs.size(); weakest-- > 0;) {
        const UsdPrim::Spec& own = prim.specs[weakest];
        const UsdListEdit& edit = own.spec->arcs[static_cast<std::size_t>(arc)];
        const auto drop = [&list](const std::vector<UsdReference>& named) {
            if (!named.empty())
                std::erase_if(
                    list, [&named](const auto& item) { return std::ranges::find(named, item.first) != named.end(); });
        };
        if (edit.isWhole)
            list.clear();
        drop(edit.deleted);
        drop(edit.front);
        drop(edit.back);
        for (std::size_t i = 0; i < edit.front.size(); ++i)
            list.emplace(list.begin() + static_cast<std::ptrdiff_t>(i), edit.front[i], own.layer);
        for (const UsdReference& last : edit.back)
            list.emplace_back(last, own.layer);
    }
    return list;
}

/// Direct arcs are stronger than those of prims above of their kind.
void sortByStrength(std::vector<UsdPrim>& arcs)
{
    std::ranges::stable_sort(arcs, {}, [](const UsdPrim& other) { return std::pair(other.arc, other.isAncestral); });
}

} // namespace

std::string_view UsdPrim::type() const
{
    std::string_view told;
    (void)eachSpec([&told](const UsdSpec& spec) {
        told = spec.type;
        return told.empty();
    });
    return told;
}

bool UsdPrim::isActive() const
{
    bool told = true;
    (void)eachSpec([&told](const UsdSpec& spec) {
        told = spec.isActive.value_or(true);
        return !spec.isActive;
    });
    return told;
}

bool UsdPrim::isDefined() const
{
    // A class defines what inherits it, and is none itself.
    for (const Spec& own : specs)
        if (own.spec->specifier != UsdSpec::Specifier::Over)
            return own.spec->specifier == UsdSpec::Specifier::Def;
    return std::ranges::any_of(arcs, [](const UsdPrim& other) {
        return other.isDefined() || (other.arc == UsdArc::Inherits && !other.specs.empty());
    });
}

UsdOpinion UsdPrim::attribute(std::string_view name) const
{
    UsdOpinion opinion;
    (void)eachSpec([&opinion, name](const UsdSpec& spec) {
        if (const auto found = spec.attributes.find(name); found != spec.attributes.end()) {
            if (opinion.value.empty())
                opinion.value = found->second.value;
            if (opinion.interpolation.empty())
                opinion.interpolation = found->second.interpolation;
        }
        return opinion.value.empty() || opinion.interpolation.empty();
    });
    if (opinion.value == "None") // A stronger layer takes it away.
        opinion.value = {};
    return opinion;
}

std::vector<std::string_view> UsdPrim::namesWith(std::string_view prefix) const
{
    std::set<std::string_view> names;
    (void)eachSpec([&names, prefix](const UsdSpec& spec) {
        for (auto at = spec.attributes.lower_bound(prefix);
             at != spec.attributes.end() && at->first.starts_with(prefix); ++at)
            names.insert(at->first);
        return true;
    });
    return {names.begin(), names.end()};
}

std::vector<std::string_view> UsdPrim::children() const
{
    std::vector<std::string_view> names;
    std::set<std::string_view> known;
    (void)eachSpec([&names, &known](const UsdSpec& spec) {
        for (const auto& [name, child] : spec.children)
            if (known.insert(name).second)
                names.push_back(name);
        return true;
    });
    return names;
}

void UsdStage::leave(const UsdReference& reference)
{
    const QString name = reference.asset.isEmpty() ? QString::fromStdString(reference.prim) : reference.asset;
    if (m_unread.size() < kMostUnread && !m_unread.contains(name))
        m_unread.append(name);
}

const UsdText* UsdStage::scan(UsdLayer layer)
{
    for (const std::unique_ptr<UsdText>& known : m_texts)
        if (!layer.path.isEmpty() && known->source.path == layer.path)
            return known.get();
    qint64 bytes = layer.text.size();
    for (const std::unique_ptr<UsdText>& known : m_texts)
        bytes += known->source.text.size();
    if (m_texts.size() == kMostLayers || bytes > kMostBytes)
        return nullptr;
    m_texts.push_back(std::make_unique<UsdText>());
    UsdText& text = *m_texts.back();
    text.source = std::move(layer);
    const UsdScan result = scanUsd(text, m_progress, m_scanned);
    if (result != UsdScan::Whole)
        m_problem = result == UsdScan::Broken ? Problem::Broken : Problem::Stopped;
    return &text;
}

const UsdText* UsdStage::open(const QString& asset, const UsdText& from)
{
    const auto [known, isNew] = m_opened.try_emplace({&from, asset}, nullptr);
    if (!isNew || !m_opener || m_opened.size() > kMostOpened)
        return known->second;
    if (std::optional<UsdLayer> layer = m_opener(asset, from.source.path))
        known->second = scan(*std::move(layer));
    return known->second;
}

void UsdStage::addLayers(UsdLayerStack& stack, const UsdText& text)
{
    stack.push_back(&text);
    for (const UsdReference& below : text.subLayers) {
        if (!goesOn())
            return;
        const UsdText* const layer = below.asset.isEmpty() ? nullptr : open(below.asset, text);
        if (layer == nullptr)
            leave(below);
        else if (std::ranges::find(stack, layer) == stack.end())
            addLayers(stack, *layer);
    }
}

const UsdLayerStack& UsdStage::stackOf(const UsdText& text)
{
    std::unique_ptr<UsdLayerStack>& stack = m_stacks[&text];
    if (!stack) {
        stack = std::make_unique<UsdLayerStack>();
        addLayers(*stack, text);
    }
    return *stack;
}

UsdPrim UsdStage::rootOf(const UsdLayerStack& stack, int depth)
{
    UsdPrim prim;
    prim.stack = &stack;
    prim.depth = depth;
    for (const UsdText* const text : stack)
        prim.specs.push_back({.spec = &text->root, .layer = text});
    return prim;
}

UsdPrim UsdStage::root(const QByteArray& text)
{
    const UsdText* const first = scan({.text = text, .path = {}});
    if (first == nullptr) {
        m_problem = Problem::Broken;
        return {};
    }
    return rootOf(stackOf(*first), 0);
}

void UsdStage::follow(UsdPrim& prim, UsdArc arc, const UsdReference& reference, const UsdText& from)
{
    if (!goesOn())
        return;
    if (prim.depth >= kDeepestArcs || ++m_followed > kMostArcs) // It refers to itself.
        return leave(reference);
    const UsdText* const text = reference.asset.isEmpty() ? prim.stack->front() : open(reference.asset, from);
    if (text == nullptr)
        return leave(reference);
    const UsdLayerStack& stack = reference.asset.isEmpty() ? *prim.stack : stackOf(*text);
    std::string path = reference.prim;
    if (path.empty() && !text->defaultPrim.empty())
        path = "/" + std::string(text->defaultPrim);
    UsdPrim other = rootOf(stack, prim.depth + 1);
    for (std::size_t at = 1; at < path.size() && goesOn();) {
        const std::size_t end = std::min(path.find('/', at), path.size());
        chooseVariants(other);
        other = childOf(other, std::string_view(path).substr(at, end - at));
        at = end + 1;
    }
    other.arc = arc;
    if (other.specs.empty() && other.arcs.empty()) { // A class need not be there.
        if (arc != UsdArc::Inherits && arc != UsdArc::Specializes)
            leave(reference);
        return;
    }
    other.isAncestral = false;
    prim.arcs.push_back(std::move(other));
}

void UsdStage::addArcs(UsdPrim& prim)
{
    if (!std::ranges::all_of(prim.specs, [](const UsdPrim::Spec& own) { return own.spec->isActive.value_or(true); }) &&
        !prim.isActive())
        return; // Nothing of it is there.
    for (std::size_t i = 0; i < kUsdArcs && goesOn(); ++i)
        for (const auto& [reference, layer] : listOf(prim, static_cast<UsdArc>(i)))
            follow(prim, static_cast<UsdArc>(i), reference, *layer);
    sortByStrength(prim.arcs);
}

UsdPrim UsdStage::childOf(const UsdPrim& parent, std::string_view name)
{
    UsdPrim prim;
    prim.stack = parent.stack;
    prim.arc = parent.arc;
    prim.depth = parent.depth;
    if (++m_made > kMostNodes)
        m_problem = Problem::Broken;
    for (const UsdPrim::Spec& own : parent.specs)
        if (const auto found = own.spec->byName.find(name); found != own.spec->byName.end())
            prim.specs.push_back({.spec = found->second, .layer = own.layer});
    for (const UsdPrim& other : parent.arcs) {
        if (!goesOn())
            return prim;
        UsdPrim below = childOf(other, name);
        below.isAncestral = true;
        if (!below.specs.empty() || !below.arcs.empty())
            prim.arcs.push_back(std::move(below));
    }
    addArcs(prim);
    return prim;
}

/// One more variant into `prim` or one that it is made of; `whole` has the opinions on which. False where all are in.
bool UsdStage::chooseVariant(UsdPrim& prim, const UsdPrim& whole)
{
    for (const UsdPrim::Spec& own : prim.specs)
        for (const auto& [set, variants] : own.spec->variantSets) {
            std::string_view chosen;
            (void)whole.eachSpec([&chosen, &name = set](const UsdSpec& spec) {
                if (const auto found = spec.chosen.find(name); found != spec.chosen.end())
                    chosen = found->second;
                return chosen.empty();
            });
            const auto found = variants.find(chosen);
            if (found == variants.end())
                continue;
            const UsdSpec* const spec = found->second.get();
            if (std::ranges::any_of(prim.arcs, [spec](const UsdPrim& other) {
                    return other.arc == UsdArc::Variant && !other.specs.empty() && other.specs.front().spec == spec;
                }))
                continue;
            UsdPrim variant;
            variant.stack = prim.stack;
            variant.arc = UsdArc::Variant;
            variant.depth = prim.depth;
            variant.specs.push_back({.spec = spec, .layer = own.layer});
            addArcs(variant);
            prim.arcs.push_back(std::move(variant));
            sortByStrength(prim.arcs);
            return true;
        }
    return std::ranges::any_of(prim.arcs, [this, &whole](UsdPrim& other) { return chooseVariant(other, whole); });
}

void UsdStage::chooseVariants(UsdPrim& prim)
{
    while (goesOn() && chooseVariant(prim, prim))
        if (++m_made > kMostNodes)
            m_problem = Problem::Broken;
}

UsdPrim UsdStage::child(const UsdPrim& parent, std::string_view name)
{
    UsdPrim prim = childOf(parent, name);
    chooseVariants(prim);
    return prim;
}

} // namespace hairpaint::model
