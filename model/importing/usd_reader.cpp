// Reading USD text (openusd.org, "Usda File Format", "UsdGeomXformable").
#include "model/importing/usd_reader.h"

#include "model/importing/usd_curves.h"
#include "model/importing/usd_scanner.h"
#include "model/importing/usd_transform.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr int kDeepestPrim = 64;
constexpr std::size_t kMostNames = 4096; ///< Limit on the number of prims with curves.

tl::unexpected<Clause> brokenUsd()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "its USD text is broken or cut short; export it again")),
                  Clause::Cure::OtherFile);
}

bool isSpecifier(std::string_view word)
{
    return word == "def" || word == "over" || word == "class";
}

/// Reads one text.
class UsdReader
{
public:
    /// `layer`: what is read, which must outlive it.
    UsdReader(const UsdLayer& layer, const Progress& progress, UsdLayers& layers, int depth = 0)
        : m_layer(layer), m_scanner({layer.text.constData(), static_cast<std::size_t>(layer.text.size())}),
          m_size(static_cast<double>(layer.text.size())), m_progress(progress), m_layers(layers), m_depth(depth)
    {}

    Checked<std::optional<ForeignCurves>> read()
    {
        readLayer();
        if (m_isCancelled)
            return std::optional<ForeignCurves>();
        if (m_problem)
            return tl::unexpected(*m_problem);
        if (m_scanner.isBroken())
            return brokenUsd();
        if (m_curves.groups.empty() && (m_sawNurbs || !m_layers.unread.isEmpty()))
            return holdsOther();
        const auto isGuides = [](const ForeignStrands& strands) { return strands.isGuides; };
        if (!std::ranges::all_of(m_curves.groups, isGuides))
            std::erase_if(m_curves.groups, isGuides);
        return std::optional<ForeignCurves>(std::move(m_curves));
    }

private:
    [[nodiscard]] tl::unexpected<Clause> holdsOther() const
    {
        return m_sawNurbs
                   ? refuse(say(QT_TRANSLATE_NOOP("Files", "its curves are NURBS, which are not read; export "
                                                           "them as basis curves")),
                            Clause::Cure::OtherFile)
                   : refuse(say(QT_TRANSLATE_NOOP("Files", "its hair is in other files, which are no USD text "
                                                           "beside it: %1; export it flattened into one"))
                                .arg(shownPath(m_layers.unread.first(std::min<qsizetype>(m_layers.unread.size(), 3))
                                                   .join(QStringLiteral(", ")))),
                            Clause::Cure::OtherFile);
    }
    void readLayer()
    {
        m_curves.upAxis = UpAxis::Y; // Unless told.
        m_curves.metresPerUnit = 0.01F;
        if (m_scanner.peek() == '(')
            readStage();
        while (!m_scanner.atEnd() && goesOn())
            readPrim(0, {});
        for (const UsdReference& below : m_below)
            follow(below, false, false);
    }
    /// Adds what another layer holds, or another prim of this one. `ofPrim`: of the prim that is named, or of the
    /// default one, which stays where it stands where `isMoved`.
    void follow(const UsdReference& reference, bool ofPrim, bool isMoved)
    {
        constexpr int kDeepest = 8;
        if (!goesOn())
            return;
        std::optional<UsdLayer> other;
        if (m_depth >= kDeepest) // It refers to itself.
            return m_layers.leave(reference);
        if (!m_layers.open(reference, m_layer.path, other))
            return;
        const Progress progress = [this](double) { return askProgress(); };
        UsdReader reader(other ? *other : m_layer, progress, m_layers, m_depth + 1);
        reader.m_wanted = reference.prim;
        reader.m_wantsDefault = ofPrim && reference.prim.empty();
        reader.m_keepsTransform = !isMoved;
        reader.readLayer();
        m_isCancelled = m_isCancelled || reader.m_isCancelled;
        m_sawNurbs = m_sawNurbs || reader.m_sawNurbs;
        if (reader.m_problem)
            m_problem = reader.m_problem;
        if (reader.m_scanner.isBroken() || m_curves.groups.size() + reader.m_curves.groups.size() > kMostNames)
            return m_scanner.setBroken();
        std::ranges::move(reader.m_curves.groups, std::back_inserter(m_curves.groups));
    }
    [[nodiscard]] bool goesOn() const { return !m_isCancelled && !m_problem && !m_scanner.isBroken(); }
    [[nodiscard]] std::string_view nextWord() const
    {
        UsdScanner ahead = m_scanner;
        return ahead.word();
    }
    bool askProgress()
    {
        m_isCancelled =
            m_isCancelled || (m_progress && !m_progress(static_cast<double>(m_scanner.position()) / m_size));
        return !m_isCancelled;
    }

    void readStage()
    {
        m_scanner.expect('(');
        while (!m_scanner.accept(')') && goesOn()) {
            if (const char next = m_scanner.peek(); next == '"' || next == '\'') {
                m_scanner.skipValue();
                continue;
            }
            const std::string_view key = m_scanner.word();
            if (key.empty()) {
                m_scanner.setBroken();
            } else if (m_scanner.accept('=')) {
                if (key == "metersPerUnit") {
                    const double unit = m_scanner.number().value_or(0.0);
                    if (unit > 0.0 && unit < 1e6)
                        m_curves.metresPerUnit = static_cast<float>(unit);
                } else if (key == "subLayers") {
                    m_below = readReferences(m_scanner);
                } else if (key == "defaultPrim" && m_wantsDefault) {
                    m_wanted = "/" + std::string(m_scanner.quoted());
                } else if (key == "upAxis") {
                    m_curves.upAxis = m_scanner.quoted() == "Z" ? UpAxis::Z : UpAxis::Y;
                } else {
                    m_scanner.skipValue();
                }
            }
        }
    }

    /// From its "def" on. `parent`: its path.
    void readPrim(int depth, const std::string& parent)
    {
        const std::string_view specifier = m_scanner.word();
        if (depth > kDeepestPrim || !isSpecifier(specifier))
            return m_scanner.setBroken();
        const std::string_view type = m_scanner.peek() == '"' ? std::string_view() : m_scanner.word();
        const std::string_view name = m_scanner.quoted();
        UsdCurves curves;
        curves.path = parent + "/" + std::string(name);
        const bool isWanted = m_wanted.empty() || (curves.path + "/").starts_with(m_wanted + "/");
        const bool holdsWanted = m_wanted.starts_with(curves.path + "/");
        std::vector<UsdReference> references;
        if (m_scanner.peek() == '(')
            readPrimMetadata(curves, references);
        m_sawNurbs = m_sawNurbs || (isWanted && type == "NurbsCurves");
        // A class is only there for those that inherit it.
        if (!(isWanted || holdsWanted) || (specifier == "class" && m_wanted.empty())) {
            m_scanner.skipValue();
            return;
        }
        m_scanner.expect('{');
        UsdTransform transform;
        curves.groupName = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
        const std::size_t firstGroup = m_curves.groups.size();
        while (!m_scanner.accept('}') && goesOn())
            readStatement(depth, curves, transform);
        if (!goesOn() || !isWanted)
            return;
        if (type == "BasisCurves" && !curves.isHidden && !curves.counts.empty())
            add(curves);
        for (std::size_t i = 0; i < references.size() && !curves.isHidden; ++i)
            follow(references[i], true, transform.isTold());
        if (curves.isHidden)
            m_curves.groups.resize(firstGroup);
        if (m_keepsTransform || curves.path != m_wanted)
            move(firstGroup, transform);
    }

    void add(const UsdCurves& curves)
    {
        std::optional<std::vector<ForeignStrands>> groups = strandsOf(curves);
        if (!groups || m_curves.groups.size() + groups->size() > kMostNames)
            return m_scanner.setBroken();
        for (ForeignStrands& strands : *groups)
            m_curves.groups.push_back(std::move(strands));
    }

    /// What the prim holds, as it moves it.
    void move(std::size_t firstGroup, const UsdTransform& transform)
    {
        const std::optional<glm::mat4> matrix = transform.toParent();
        if (!matrix)
            return refuseTransform();
        if (*matrix == glm::mat4(1.0F))
            return;
        for (std::size_t i = firstGroup; i < m_curves.groups.size(); ++i) {
            for (glm::vec3& point : m_curves.groups[i].points)
                point = glm::vec3(*matrix * glm::vec4(point, 1.0F));
            const float larger = std::cbrt(std::abs(glm::determinant(glm::mat3(*matrix))));
            for (StrandLook& look : m_curves.groups[i].looks) {
                look.rootWidth *= larger;
                look.tipWidth *= larger;
            }
        }
    }
    void refuseTransform()
    {
        m_problem =
            Clause{.text = say(QT_TRANSLATE_NOOP("Files", "it moves its hair in a way that is not known to this "
                                                          "program; apply all transforms and export it again")),
                   .cure = Clause::Cure::OtherFile};
    }

    void readStatement(int depth, UsdCurves& curves, UsdTransform& transform)
    {
        if (m_scanner.accept(';'))
            return;
        const std::string_view first = nextWord();
        if (isSpecifier(first))
            return readPrim(depth + 1, curves.path);
        if (first == "variantSet") {
            (void)m_scanner.word();
            return readVariants(depth, curves, transform);
        }
        // Qualifiers and a type stand before the name: it is the last word.
        std::string_view name;
        while (!nextWord().empty() && !isSpecifier(nextWord()))
            name = m_scanner.word();
        if (name.empty())
            return m_scanner.setBroken();
        if (m_scanner.accept('='))
            readValue(name, curves, transform);
        if (m_scanner.peek() == '(')
            readValueMetadata(name, curves);
    }

    /// "style" = { "long" { ... } "bald" { ... } }: of the one that the prim has chosen.
    void readVariants(int depth, UsdCurves& curves, UsdTransform& transform)
    {
        const auto chosen = curves.variants.find(m_scanner.quoted());
        m_scanner.expect('=');
        m_scanner.expect('{');
        while (!m_scanner.accept('}') && goesOn()) {
            const std::string_view name = m_scanner.quoted();
            if (m_scanner.peek() == '(')
                m_scanner.skipValue();
            if (chosen == curves.variants.end() || chosen->second != name) {
                m_scanner.skipValue();
                continue;
            }
            m_scanner.expect('{');
            if (depth >= kDeepestPrim)
                return m_scanner.setBroken();
            while (!m_scanner.accept('}') && goesOn())
                readStatement(depth + 1, curves, transform);
        }
    }

    /// visit(key) for each "key = value" of what stands in brackets; it reads the value, or returns false.
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
            const std::string_view key = m_scanner.word();
            if (key.empty())
                m_scanner.setBroken();
            else if (m_scanner.accept('=') && !visit(key))
                m_scanner.skipValue();
        }
    }

    void readPrimMetadata(UsdCurves& curves, std::vector<UsdReference>& references)
    {
        readMetadata([this, &curves, &references](std::string_view key) {
            if (key == "active") {
                const std::string_view value = m_scanner.word();
                curves.isHidden = curves.isHidden || value == "false" || value == "0";
                return true;
            }
            if (key == "variants") {
                m_scanner.expect('{');
                while (!m_scanner.accept('}') && goesOn()) {
                    (void)m_scanner.word(); // "string"
                    const std::string_view set = m_scanner.word();
                    m_scanner.expect('=');
                    curves.variants.insert_or_assign(set, m_scanner.quoted());
                    m_scanner.accept(',');
                    m_scanner.accept(';');
                }
                return true;
            }
            if (key != "references" && key != "payload" && key != "inherits" && key != "specializes")
                return false;
            std::ranges::move(readReferences(m_scanner), std::back_inserter(references));
            return true;
        });
    }

    void readValueMetadata(std::string_view name, UsdCurves& curves)
    {
        readMetadata([this, name, &curves](std::string_view key) {
            if (key != "interpolation")
                return false;
            const std::string_view told = m_scanner.quoted();
            if (UsdPrimvar* primvar = primvarOf(name, curves))
                primvar->interpolation = told;
            return true;
        });
    }

    /// Null where it is none that hair is read from.
    static UsdPrimvar* primvarOf(std::string_view name, UsdCurves& curves)
    {
        constexpr std::string_view kPrefix = "primvars:";
        static const std::set<std::string_view> kKnown{"widths",      "width",       "displayColor",  "groom_width",
                                                       "groom_color", "groom_guide", "groom_group_id"};
        if (name.starts_with(kPrefix))
            name.remove_prefix(kPrefix.size());
        else if (name != "widths")
            return nullptr;
        return kKnown.contains(name) ? &curves.primvars[std::string(name)] : nullptr;
    }

    void readValue(std::string_view name, UsdCurves& curves, UsdTransform& transform)
    {
        constexpr std::string_view kSamples = ".timeSamples";
        if (!name.ends_with(kSamples))
            return readOneValue(name, curves, transform);
        name.remove_suffix(kSamples.size());
        m_scanner.expect('{');
        bool isFirst = true;
        while (!m_scanner.accept('}') && goesOn()) {
            (void)m_scanner.number();
            m_scanner.expect(':');
            if (isFirst)
                readOneValue(name, curves, transform);
            else
                m_scanner.skipValue();
            isFirst = false;
            m_scanner.accept(',');
        }
    }

    void readOneValue(std::string_view name, UsdCurves& curves, UsdTransform& transform)
    {
        const auto numbers = [this](std::vector<float>& values, std::size_t most) {
            values.clear();
            if (m_scanner.peek() == 'N') // None.
                m_scanner.skipValue();
            else
                (void)m_scanner.numbers(values, most, [this] { return askProgress(); });
        };
        const auto token = [this](std::string_view& value) { value = m_scanner.quoted(); };
        if (name == "points") {
            numbers(curves.points, 3 * kMostForeignPoints);
        } else if (name == "curveVertexCounts") {
            numbers(curves.counts, kMostForeignStrands);
        } else if (constexpr std::string_view kIndices = ":indices"; name.ends_with(kIndices)) {
            if (UsdPrimvar* primvar = primvarOf(name.substr(0, name.size() - kIndices.size()), curves))
                numbers(primvar->indices, kMostForeignPoints);
            else
                m_scanner.skipValue();
        } else if (UsdPrimvar* primvar = primvarOf(name, curves)) {
            numbers(primvar->values, 3 * kMostForeignPoints);
        } else if (name == "wrap") {
            token(curves.wrap);
        } else if (name == "purpose") {
            const std::string_view purpose = m_scanner.quoted();
            curves.isHidden = curves.isHidden || purpose == "guide" || purpose == "proxy";
        } else if (name == "type") {
            token(curves.type);
        } else if (name == "basis") {
            token(curves.basis);
        } else if (name == "visibility") {
            curves.isHidden = m_scanner.quoted() == "invisible" || curves.isHidden;
        } else if (name == "primvars:groom_group_name") {
            readGroupName(curves);
        } else if (name == "xformOpOrder") {
            readOrder(transform);
        } else if (name.starts_with("xformOp:")) {
            std::vector<float> values;
            numbers(values, 16);
            if (!m_scanner.isBroken() && !transform.addOperation(name, values))
                refuseTransform();
        } else {
            m_scanner.skipValue();
        }
    }

    void readGroupName(UsdCurves& curves)
    {
        const bool isArray = m_scanner.accept('[');
        const std::string_view text = m_scanner.quoted();
        QString name = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
        curves.groupName = name.replace(QLatin1String("\\\""), QLatin1String("\""))
                               .replace(QLatin1String("\\\\"), QLatin1String("\\"));
        while (isArray && !m_scanner.accept(']') && goesOn())
            if (!m_scanner.accept(','))
                m_scanner.skipValue();
    }

    void readOrder(UsdTransform& transform)
    {
        m_scanner.expect('[');
        while (!m_scanner.accept(']') && goesOn()) {
            transform.addToOrder(m_scanner.quoted());
            m_scanner.accept(',');
        }
    }

    const UsdLayer& m_layer;
    UsdScanner m_scanner;
    double m_size;
    const Progress& m_progress;
    UsdLayers& m_layers;
    int m_depth; ///< Depth of references between layers and prims.
    ForeignCurves m_curves;
    std::vector<UsdReference> m_below; ///< Layers under this one.
    std::string m_wanted;              ///< The prim that is read alone; empty: all.
    bool m_wantsDefault = false;
    bool m_keepsTransform = true; ///< Whether the wanted prim keeps its own transform.
    std::optional<Clause> m_problem;
    bool m_isCancelled = false;
    bool m_sawNurbs = false;
};

} // namespace

Checked<std::optional<ForeignCurves>> readUsdText(const QByteArray& text, const Progress& progress,
                                                  const UsdOpener& opener)
{
    if (text.startsWith("PXR-USDC"))
        return refuse(
            say(QT_TRANSLATE_NOOP("Files", "it is USD in its binary form, which is not read; save it as text, "
                                           "with the ending .usda")),
            Clause::Cure::OtherFile);
    if (!text.startsWith("#usda "))
        return refuse(say(QT_TRANSLATE_NOOP("Files", "it is no USD text; choose a file that another program saved as "
                                                     ".usda")),
                      Clause::Cure::OtherFile);
    const UsdLayer first{.text = text, .path = {}};
    UsdLayers layers{.opener = opener, .unread = {}};
    return UsdReader(first, progress, layers).read();
}

} // namespace hairpaint::model
