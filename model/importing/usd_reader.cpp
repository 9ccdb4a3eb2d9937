// Reading USD text (openusd.org, "Usda File Format", "UsdGeomBasisCurves", "UsdGeomXformable").
#include "model/importing/usd_reader.h"

#include "model/importing/usd_scanner.h"
#include "model/importing/usd_transform.h"
#include "model/values/srgb.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace hairpaint::model {

namespace {

constexpr int kDeepestPrim = 64;
constexpr std::size_t kMostNames = 4096; ///< Of prims with curves.

tl::unexpected<Clause> brokenUsd()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "its USD text is broken or cut short; export it again")),
                  Clause::Cure::OtherFile);
}

/// What one BasisCurves says.
struct UsdCurves
{
    std::vector<float> counts;
    std::vector<float> points;
    std::vector<float> widths;
    std::vector<float> colours;
    std::vector<float> guides;
    std::string_view type = "cubic"; ///< Unless told.
    std::string_view basis = "bezier";
    QString groupName;
    bool isHidden = false;
};

/// One value a point, a curve, or for all of them.
template<typename Value>
class PerPoint
{
public:
    PerPoint(const std::vector<float>& values, std::size_t curves, std::size_t points)
        : m_values(values), m_count(values.size() / kEach), m_curves(curves), m_points(points)
    {}
    [[nodiscard]] bool isTold() const
    {
        return m_values.size() % kEach == 0 && (m_count == 1 || m_count == m_curves || m_count == m_points);
    }
    [[nodiscard]] Value at(std::size_t curve, std::size_t point) const
    {
        const std::size_t index = m_count == m_points ? point : m_count == m_curves ? curve : 0;
        Value value;
        if constexpr (kEach == 1)
            value = m_values[index];
        else
            value = {m_values[3 * index], m_values[3 * index + 1], m_values[3 * index + 2]};
        return value;
    }

private:
    static constexpr std::size_t kEach = std::is_same_v<Value, float> ? 1 : 3;
    const std::vector<float>& m_values;
    std::size_t m_count;
    std::size_t m_curves;
    std::size_t m_points;
};

glm::vec3 asEncoded(const glm::vec3& linear)
{
    const auto channel = [](float value) {
        return std::isfinite(value) ? srgbFromLinear(std::clamp(value, 0.0F, 1.0F)) : 0.0F;
    };
    return {channel(linear.r), channel(linear.g), channel(linear.b)};
}

/// Points that a curve runs through, of those that tell it.
void addCurve(const UsdCurves& curves, std::span<const glm::vec3> told, std::vector<glm::vec3>& points)
{
    if (curves.type == "cubic" && curves.basis == "bezier" && told.size() >= 4) {
        for (std::size_t i = 0; i < told.size(); i += 3)
            points.push_back(told[i]);
    } else if (curves.type == "cubic" && curves.basis == "bspline" && told.size() >= 4) {
        for (std::size_t i = 0; i + 2 < told.size(); ++i)
            points.push_back((told[i] + 4.0F * told[i + 1] + told[i + 2]) / 6.0F);
    } else {
        points.insert(points.end(), told.begin(), told.end());
    }
}

/// None where its counts do not agree.
std::optional<ForeignStrands> strandsOf(const UsdCurves& curves)
{
    std::vector<glm::vec3> told(curves.points.size() / 3);
    for (std::size_t i = 0; i < told.size(); ++i)
        told[i] = {curves.points[3 * i], curves.points[3 * i + 1], curves.points[3 * i + 2]};
    if (curves.points.size() % 3 != 0 || !std::ranges::all_of(curves.points, [](float v) { return std::isfinite(v); }))
        return std::nullopt;
    const PerPoint<float> widths(curves.widths, curves.counts.size(), told.size());
    const PerPoint<glm::vec3> colours(curves.colours, curves.counts.size(), told.size());
    ForeignStrands strands;
    strands.name = curves.groupName;
    strands.hasColours = !curves.colours.empty() && colours.isTold();
    strands.isGuides = !curves.guides.empty() && std::ranges::all_of(curves.guides, [](float v) { return v != 0.0F; });
    std::size_t first = 0;
    for (std::size_t i = 0; i < curves.counts.size(); ++i) {
        const float count = curves.counts[i];
        if (!(count >= 2.0F) || count > static_cast<float>(told.size() - first) || count != std::floor(count))
            return std::nullopt;
        const std::size_t last = first + static_cast<std::size_t>(count) - 1;
        addCurve(curves, std::span(told).subspan(first, last - first + 1), strands.points);
        strands.ends.push_back(static_cast<std::uint32_t>(strands.points.size()));
        StrandLook look;
        if (!curves.widths.empty() && widths.isTold()) {
            const auto wide = [](float width) { return std::isfinite(width) && width > 0.0F ? width : 0.0F; };
            look.rootWidth = wide(widths.at(i, first));
            look.tipWidth = wide(widths.at(i, last));
        }
        if (strands.hasColours) {
            look.rootColour = asEncoded(colours.at(i, first));
            look.tipColour = asEncoded(colours.at(i, last));
        }
        strands.looks.push_back(look);
        first = last + 1;
    }
    return first == told.size() ? std::optional<ForeignStrands>(std::move(strands)) : std::nullopt;
}

bool isSpecifier(std::string_view word)
{
    return word == "def" || word == "over" || word == "class";
}

/// Reads one text.
class UsdReader
{
public:
    UsdReader(const QByteArray& text, const Progress& progress)
        : m_scanner({text.constData(), static_cast<std::size_t>(text.size())}),
          m_size(static_cast<double>(text.size())), m_progress(progress)
    {}

    Checked<std::optional<ForeignCurves>> read()
    {
        m_curves.upAxis = UpAxis::Y; // Unless told.
        m_curves.metresPerUnit = 0.01F;
        if (m_scanner.peek() == '(')
            readStage();
        while (!m_scanner.atEnd() && goesOn())
            readPrim(0);
        if (m_isCancelled)
            return std::optional<ForeignCurves>();
        if (m_problem)
            return tl::unexpected(*m_problem);
        if (m_scanner.isBroken())
            return brokenUsd();
        const auto isGuides = [](const ForeignStrands& strands) { return strands.isGuides; };
        if (!std::ranges::all_of(m_curves.groups, isGuides))
            std::erase_if(m_curves.groups, isGuides);
        return std::optional<ForeignCurves>(std::move(m_curves));
    }

private:
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
                } else if (key == "upAxis") {
                    m_curves.upAxis = m_scanner.quoted() == "Z" ? UpAxis::Z : UpAxis::Y;
                } else {
                    m_scanner.skipValue();
                }
            }
        }
    }

    /// From its "def" on.
    void readPrim(int depth)
    {
        const std::string_view specifier = m_scanner.word();
        if (depth > kDeepestPrim || !isSpecifier(specifier))
            return m_scanner.setBroken();
        const std::string_view type = m_scanner.peek() == '"' ? std::string_view() : m_scanner.word();
        const std::string_view name = m_scanner.quoted();
        if (m_scanner.peek() == '(')
            m_scanner.skipValue();
        if (specifier == "class") {
            m_scanner.skipValue();
            return;
        }
        m_scanner.expect('{');
        UsdCurves curves;
        UsdTransform transform;
        curves.groupName = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
        const std::size_t firstGroup = m_curves.groups.size();
        while (!m_scanner.accept('}') && goesOn())
            readStatement(depth, curves, transform);
        if (!goesOn())
            return;
        if (type == "BasisCurves" && !curves.isHidden)
            add(curves);
        if (curves.isHidden)
            m_curves.groups.resize(firstGroup);
        move(firstGroup, transform);
    }

    void add(const UsdCurves& curves)
    {
        std::optional<ForeignStrands> strands = strandsOf(curves);
        if (!strands || m_curves.groups.size() == kMostNames)
            m_scanner.setBroken();
        else
            m_curves.groups.push_back(std::move(*strands));
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
            return readPrim(depth + 1);
        if (first == "variantSet") {
            (void)m_scanner.word();
            m_scanner.skipValue(); // Its name.
            m_scanner.expect('=');
            m_scanner.skipValue();
            return;
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
            m_scanner.skipValue();
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
        } else if (name == "widths") {
            numbers(curves.widths, kMostForeignPoints);
        } else if (name == "primvars:displayColor") {
            numbers(curves.colours, 3 * kMostForeignPoints);
        } else if (name == "primvars:groom_guide") {
            numbers(curves.guides, kMostForeignStrands);
        } else if (name == "type") {
            token(curves.type);
        } else if (name == "basis") {
            token(curves.basis);
        } else if (name == "visibility") {
            curves.isHidden = m_scanner.quoted() == "invisible";
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

    UsdScanner m_scanner;
    double m_size;
    const Progress& m_progress;
    ForeignCurves m_curves;
    std::optional<Clause> m_problem;
    bool m_isCancelled = false;
};

} // namespace

Checked<std::optional<ForeignCurves>> readUsdText(const QByteArray& text, const Progress& progress)
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
    return UsdReader(text, progress).read();
}

} // namespace hairpaint::model
