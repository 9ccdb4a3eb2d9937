// From "def" to "def" (openusd.org, "Usda File Format").
#include "model/importing/usd_specs.h"

#include "model/importing/usd_scanner.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace hairpaint::model {

namespace {

constexpr int kDeepestPrim = 64;
constexpr std::size_t kMostPrims = std::size_t{1} << 18U;
constexpr std::size_t kMostNamed = 1024; ///< Of a prim, in a list.
constexpr std::string_view kPrimvars = "primvars:";
constexpr std::string_view kIndices = ":indices";

bool isSpecifier(std::string_view word)
{
    return word == "def" || word == "over" || word == "class";
}

bool isListEdit(std::string_view word)
{
    return word == "prepend" || word == "append" || word == "add" || word == "delete" || word == "reorder";
}

bool isOfHair(std::string_view name)
{
    static const std::set<std::string_view> kOwn{"points", "curveVertexCounts", "widths",     "wrap",        "type",
                                                 "basis",  "purpose",           "visibility", "xformOpOrder"};
    if (kOwn.contains(name) || name.starts_with("xformOp:"))
        return true;
    if (name.ends_with(kIndices))
        name.remove_suffix(kIndices.size());
    if (name.starts_with(kPrimvars))
        name.remove_prefix(kPrimvars.size());
    else if (name != "widths")
        return false;
    return std::ranges::find(kHairPrimvars, name) != kHairPrimvars.end() || name == "groom_group_name";
}

std::optional<UsdArc> arcNamed(std::string_view key)
{
    if (key == "inherits")
        return UsdArc::Inherits;
    if (key == "references")
        return UsdArc::References;
    if (key == "payload")
        return UsdArc::Payload;
    return key == "specializes" ? std::optional(UsdArc::Specializes) : std::nullopt;
}

/// Reads one text.
class SpecReader
{
public:
    SpecReader(UsdText& text, const Progress& progress, std::size_t& prims)
        : m_text(text), m_scanner({text.source.text.constData(), static_cast<std::size_t>(text.source.text.size())}),
          m_size(static_cast<double>(text.source.text.size())), m_progress(progress), m_prims(prims)
    {}

    UsdScan read()
    {
        if (m_scanner.peek() == '(')
            readStage();
        while (!m_scanner.atEnd() && goesOn())
            readPrim(m_text.root, 0);
        if (m_isStopped)
            return UsdScan::Stopped;
        return m_scanner.isBroken() ? UsdScan::Broken : UsdScan::Whole;
    }

private:
    [[nodiscard]] bool goesOn() const { return !m_isStopped && !m_scanner.isBroken(); }
    [[nodiscard]] std::string_view nextWord() const
    {
        UsdScanner ahead = m_scanner;
        return ahead.word();
    }

    void readStage()
    {
        readMetadata([this](std::string_view key, std::string_view /*edit*/) {
            if (key == "metersPerUnit") {
                const double unit = m_scanner.number().value_or(0.0);
                if (unit > 0.0 && unit < 1e6)
                    m_text.metresPerUnit = unit;
            } else if (key == "subLayers") {
                m_text.subLayers = readReferences(m_scanner);
            } else if (key == "defaultPrim") {
                m_text.defaultPrim = m_scanner.quoted();
            } else if (key == "upAxis") {
                m_text.isZUp = m_scanner.quoted() == "Z";
            } else {
                return false;
            }
            return true;
        });
    }

    /// visit(key, edit) for each "edit key = value" of what stands in brackets; it reads the value, or returns false.
    template<typename Visit>
    void readMetadata(const Visit& visit)
    {
        m_scanner.expect('(');
        while (!m_scanner.accept(')') && goesOn()) {
            if (m_scanner.accept(';') || m_scanner.accept(','))
                continue;
            if (const char next = m_scanner.peek(); next == '"' || next == '\'') {
                m_scanner.skipValue();
                continue;
            }
            std::string_view key = m_scanner.word();
            std::string_view edit;
            if (isListEdit(key) && m_scanner.peek() != '=') {
                edit = key;
                key = m_scanner.word();
            }
            if (key.empty())
                m_scanner.setBroken();
            else if (m_scanner.accept('=') && !visit(key, edit))
                m_scanner.skipValue();
        }
    }

    /// From its specifier on.
    void readPrim(UsdSpec& parent, int depth)
    {
        const std::string_view specifier = m_scanner.word();
        if (depth > kDeepestPrim || !isSpecifier(specifier) || ++m_prims > kMostPrims)
            return m_scanner.setBroken();
        if (m_progress && !m_progress(static_cast<double>(m_scanner.position()) / m_size)) {
            m_isStopped = true;
            return;
        }
        const std::string_view type = m_scanner.peek() == '"' ? std::string_view() : m_scanner.word();
        const std::string_view name = m_scanner.quoted();
        if (!goesOn())
            return;
        UsdSpec& spec = parent.child(name);
        if (specifier != "over")
            spec.specifier = specifier == "def" ? UsdSpec::Specifier::Def : UsdSpec::Specifier::Class;
        if (!type.empty())
            spec.type = type;
        readBody(spec, depth);
    }

    void readBody(UsdSpec& spec, int depth)
    {
        if (m_scanner.peek() == '(')
            readMetadata(
                [this, &spec](std::string_view key, std::string_view edit) { return readOfPrim(spec, key, edit); });
        m_scanner.expect('{');
        while (!m_scanner.accept('}') && goesOn())
            readStatement(spec, depth);
    }

    bool readOfPrim(UsdSpec& spec, std::string_view key, std::string_view edit)
    {
        if (key == "active") {
            const std::string_view value = m_scanner.word();
            spec.isActive = value != "false" && value != "0";
            return true;
        }
        if (key == "variants") {
            m_scanner.expect('{');
            while (!m_scanner.accept('}') && goesOn()) {
                (void)m_scanner.word(); // "string"
                const std::string_view set = m_scanner.word();
                m_scanner.expect('=');
                spec.chosen.insert_or_assign(set, m_scanner.quoted());
                m_scanner.accept(',');
                m_scanner.accept(';');
            }
            return true;
        }
        const std::optional<UsdArc> arc = arcNamed(key);
        if (!arc)
            return false;
        UsdListEdit& list = spec.arcs[static_cast<std::size_t>(*arc)];
        std::vector<UsdReference> named = readReferences(m_scanner);
        std::vector<UsdReference>& all = edit == "delete"                    ? list.deleted
                                         : edit == "append" || edit == "add" ? list.back
                                                                             : list.front;
        list.isWhole = list.isWhole || edit.empty();
        if (edit != "reorder")
            std::ranges::move(named, std::back_inserter(all));
        if (all.size() > kMostNamed)
            m_scanner.setBroken();
        return true;
    }

    void readStatement(UsdSpec& spec, int depth)
    {
        if (m_scanner.accept(';'))
            return;
        const std::string_view first = nextWord();
        if (isSpecifier(first))
            return readPrim(spec, depth + 1);
        if (first == "variantSet") {
            (void)m_scanner.word();
            return readVariants(spec, depth);
        }
        // Qualifiers and a type stand before the name: it is the last word.
        std::string_view name;
        while (!nextWord().empty() && !isSpecifier(nextWord()))
            name = m_scanner.word();
        if (name.empty())
            return m_scanner.setBroken();
        constexpr std::string_view kSamples = ".timeSamples";
        const bool isAnimated = name.ends_with(kSamples);
        if (isAnimated)
            name.remove_suffix(kSamples.size());
        UsdOpinion* const opinion = isOfHair(name) ? &spec.attributes[name] : nullptr;
        if (m_scanner.accept('=')) {
            const std::string_view value = isAnimated ? firstSample() : valueText();
            if (opinion != nullptr && !value.empty())
                opinion->value = value;
        }
        if (m_scanner.peek() == '(')
            readMetadata([this, opinion](std::string_view key, std::string_view /*edit*/) {
                if (key != "interpolation" || opinion == nullptr)
                    return false;
                opinion->interpolation = m_scanner.quoted();
                return true;
            });
    }

    [[nodiscard]] std::string_view valueText()
    {
        (void)m_scanner.peek(); // To where it begins.
        const std::size_t begin = m_scanner.position();
        m_scanner.skipValue();
        const std::string_view whole(m_text.source.text.constData(),
                                     static_cast<std::size_t>(m_text.source.text.size()));
        return m_scanner.isBroken() ? std::string_view() : whole.substr(begin, m_scanner.position() - begin);
    }
    [[nodiscard]] std::string_view firstSample()
    {
        std::string_view first;
        m_scanner.expect('{');
        while (!m_scanner.accept('}') && goesOn()) {
            (void)m_scanner.number();
            m_scanner.expect(':');
            const std::string_view value = valueText();
            first = first.empty() ? value : first;
            m_scanner.accept(',');
        }
        return first;
    }

    /// "style" = { "long" { ... } "bald" { ... } }
    void readVariants(UsdSpec& spec, int depth)
    {
        UsdSpec::Variants& variants = spec.variantSets[m_scanner.quoted()];
        m_scanner.expect('=');
        m_scanner.expect('{');
        while (!m_scanner.accept('}') && goesOn()) {
            std::unique_ptr<UsdSpec>& variant = variants[m_scanner.quoted()];
            if (depth >= kDeepestPrim || ++m_prims > kMostPrims)
                return m_scanner.setBroken();
            if (!variant)
                variant = std::make_unique<UsdSpec>();
            readBody(*variant, depth + 1);
        }
    }

    UsdText& m_text;
    UsdScanner m_scanner;
    double m_size;
    const Progress& m_progress;
    std::size_t& m_prims;
    bool m_isStopped = false;
};

} // namespace

UsdSpec& UsdSpec::child(std::string_view name)
{
    UsdSpec*& found = byName[name];
    if (found == nullptr) {
        children.emplace_back(name, std::make_unique<UsdSpec>());
        found = children.back().second.get();
    }
    return *found;
}

UsdScan scanUsd(UsdText& text, const Progress& progress, std::size_t& prims)
{
    return SpecReader(text, progress, prims).read();
}

} // namespace hairpaint::model
