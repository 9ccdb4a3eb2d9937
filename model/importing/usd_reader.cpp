// The prims of a stage from above down, with what they have from those above (openusd.org, "UsdGeomImageable").
#include "model/importing/usd_reader.h"

#include "model/importing/usd_curves.h"
#include "model/importing/usd_scanner.h"
#include "model/importing/usd_stage.h"
#include "model/importing/usd_transform.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr int kMostComposedDepth = 256;  ///< Limit on the depth of composed prims.
constexpr std::size_t kMostNames = 4096; ///< Limit on the number of prims with curves.
constexpr double kScanned = 0.3;         ///< Fraction of all work that scanning the layers is.

tl::unexpected<Clause> brokenUsd()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "its USD text is broken or cut short; export it again")),
                  Clause::Cure::OtherFile);
}

tl::unexpected<Clause> unknownTransform()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "it moves its hair in a way that is not known to this program; apply "
                                                 "all transforms and export it again")),
                  Clause::Cure::OtherFile);
}

/// What a prim has from those above it.
struct Inherited
{
    glm::mat4 toStage{1.0F};
    bool isMovedOddly = false; ///< toStage is not known.
    std::string_view purpose;
    std::map<std::string, UsdPrimvar, std::less<>> primvars; ///< One value for all that is below.
};

/// Text without what it begins and ends with.
std::string_view tokenOf(const UsdOpinion& opinion)
{
    return opinion.value.empty() ? std::string_view() : UsdScanner(opinion.value).quoted();
}

QString groupNameOf(const UsdPrim& prim, std::string_view name)
{
    for (const std::string_view told : {"primvars:groom_group_name", "groom_group_name"})
        if (const std::string_view value = prim.attribute(told).value; !value.empty()) {
            UsdScanner scanner(value);
            scanner.accept('[');
            name = scanner.quoted();
            break;
        }
    QString text = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    return text.replace(QLatin1String("\\\""), QLatin1String("\"")).replace(QLatin1String("\\\\"), QLatin1String("\\"));
}

class UsdReader
{
public:
    UsdReader(const Progress& progress, const UsdOpener& opener)
        : m_progress(progress), m_stage(opener, [this](double done) { return tell(kScanned * done); })
    {}

    Checked<std::optional<ForeignCurves>> read(const QByteArray& text)
    {
        m_size = std::max(static_cast<double>(text.size()), 1.0);
        const UsdPrim root = m_stage.root(text);
        if (goesOn()) {
            const UsdText& first = *root.specs.front().layer;
            m_curves.upAxis = first.isZUp ? UpAxis::Z : UpAxis::Y;
            m_curves.metresPerUnit = static_cast<float>(first.metresPerUnit);
        }
        if (goesOn())
            visitChildren(root, {}, 0);
        if (m_isStopped || m_stage.problem() == UsdStage::Problem::Stopped)
            return std::optional<ForeignCurves>();
        if (m_isMovedOddly)
            return unknownTransform();
        if (m_isBroken || m_stage.problem() == UsdStage::Problem::Broken)
            return brokenUsd();
        if (m_curves.groups.empty() && (m_sawNurbs || !m_stage.unread().isEmpty()))
            return holdsOther();
        m_curves.unread = m_stage.unread();
        const auto isGuides = [](const ForeignStrands& strands) { return strands.isGuides; };
        if (!std::ranges::all_of(m_curves.groups, isGuides))
            std::erase_if(m_curves.groups, isGuides);
        return std::optional<ForeignCurves>(std::move(m_curves));
    }

private:
    [[nodiscard]] tl::unexpected<Clause> holdsOther() const
    {
        const QStringList& unread = m_stage.unread();
        return m_sawNurbs
                   ? refuse(say(QT_TRANSLATE_NOOP("Files", "its curves are NURBS, which are not read; export "
                                                           "them as basis curves")),
                            Clause::Cure::OtherFile)
                   : refuse(say(QT_TRANSLATE_NOOP("Files", "its hair is in other files, which are no USD text "
                                                           "beside it: %1; export it flattened into one"))
                                .arg(shownPath(
                                    unread.first(std::min<qsizetype>(unread.size(), 3)).join(QStringLiteral(", ")))),
                            Clause::Cure::OtherFile);
    }
    [[nodiscard]] bool goesOn() const
    {
        return !m_isStopped && !m_isBroken && !m_isMovedOddly && m_stage.problem() == UsdStage::Problem::None;
    }
    bool tell(double done)
    {
        m_done = std::clamp(done, m_done, 1.0);
        m_isStopped = m_isStopped || (m_progress && !m_progress(m_done));
        return !m_isStopped;
    }

    void visitChildren(const UsdPrim& prim, const Inherited& above, int depth)
    {
        if (depth > kMostComposedDepth) {
            m_isBroken = true;
            return;
        }
        for (const std::string_view name : prim.children()) {
            if (!goesOn())
                return;
            visit(m_stage.child(prim, name), name, above, depth + 1);
        }
    }

    void visit(const UsdPrim& prim, std::string_view name, const Inherited& above, int depth)
    {
        if (!goesOn() || !tell(m_done) || !prim.isDefined() || !prim.isActive() ||
            tokenOf(prim.attribute("visibility")) == "invisible")
            return;
        Inherited own = above;
        if (const std::string_view told = tokenOf(prim.attribute("purpose")); !told.empty())
            own.purpose = told;
        moveBy(prim, own);
        const bool isShown = own.purpose != "guide" && own.purpose != "proxy";
        const std::string_view type = prim.type();
        m_sawNurbs = m_sawNurbs || (type == "NurbsCurves" && isShown);
        if (type == "BasisCurves") {
            if (isShown)
                add(prim, name, own);
        } else {
            inheritPrimvars(prim, own);
        }
        visitChildren(prim, own, depth);
    }

    void moveBy(const UsdPrim& prim, Inherited& own)
    {
        const UsdOpinion order = prim.attribute("xformOpOrder");
        if (order.value.empty())
            return;
        UsdTransform transform;
        for (const std::string_view name : prim.namesWith("xformOp:")) {
            std::vector<float> values;
            UsdScanner scanner(prim.attribute(name).value);
            if (scanner.peek() != '\0' && scanner.numbers(values, 16, [] { return true; }))
                (void)transform.addOperation(name, values);
        }
        UsdScanner scanner(order.value);
        scanner.expect('[');
        while (!scanner.accept(']') && !scanner.isBroken()) {
            transform.addToOrder(scanner.quoted());
            scanner.accept(',');
        }
        const std::optional<glm::mat4> toParent = transform.toParent();
        if (transform.leavesParent())
            own = {.purpose = own.purpose, .primvars = std::move(own.primvars)};
        own.isMovedOddly = own.isMovedOddly || !toParent;
        own.toStage = own.toStage * toParent.value_or(glm::mat4(1.0F));
    }

    /// All numbers of a value, or what is known of it in `m_isBroken` or `m_isStopped`.
    void readNumbers(const UsdOpinion& opinion, std::size_t most, std::vector<float>& values)
    {
        if (opinion.value.empty())
            return;
        UsdScanner scanner(opinion.value);
        const bool isRead = scanner.numbers(values, most, [this] { return tell(m_done); });
        m_isBroken = m_isBroken || (!isRead && !m_isStopped);
        (void)tell(m_done + (1.0 - kScanned) * static_cast<double>(opinion.value.size()) / m_size);
    }

    [[nodiscard]] static UsdOpinion primvarOf(const UsdPrim& prim, std::string_view name, std::string_view part = {})
    {
        const std::string plain = std::string(name) + std::string(part);
        const UsdOpinion told = prim.attribute("primvars:" + plain);
        return told.value.empty() && name == "widths" ? prim.attribute(plain) : told;
    }

    static void inheritPrimvars(const UsdPrim& prim, Inherited& own)
    {
        constexpr std::size_t kMost = 3; // Of one value.
        for (const std::string_view name : kHairPrimvars) {
            const UsdOpinion told = prim.attribute("primvars:" + std::string(name));
            std::vector<float> values;
            if (!told.value.empty() && (told.interpolation.empty() || told.interpolation == "constant") &&
                UsdScanner(told.value).numbers(values, kMost, [] { return true; }))
                own.primvars.insert_or_assign(std::string(name),
                                              UsdPrimvar{.values = values, .indices = {}, .interpolation = "constant"});
        }
    }

    void add(const UsdPrim& prim, std::string_view name, const Inherited& own)
    {
        UsdCurves curves;
        readNumbers(prim.attribute("curveVertexCounts"), kMostForeignStrands, curves.counts);
        if (curves.counts.empty() || !goesOn())
            return;
        m_isMovedOddly = own.isMovedOddly;
        readNumbers(prim.attribute("points"), 3 * kMostForeignPoints, curves.points);
        curves.primvars = own.primvars;
        for (const std::string_view primvar : kHairPrimvars) {
            const UsdOpinion told = primvarOf(prim, primvar);
            if (told.value.empty() || !goesOn())
                continue;
            UsdPrimvar read{.values = {}, .indices = {}, .interpolation = told.interpolation};
            readNumbers(told, 3 * kMostForeignPoints, read.values);
            readNumbers(primvarOf(prim, primvar, ":indices"), kMostForeignPoints, read.indices);
            curves.primvars.insert_or_assign(std::string(primvar), std::move(read));
        }
        const auto take = [&prim](std::string_view attribute, std::string_view& value) {
            if (const std::string_view told = tokenOf(prim.attribute(attribute)); !told.empty())
                value = told;
        };
        take("wrap", curves.wrap);
        take("type", curves.type);
        take("basis", curves.basis);
        curves.groupName = groupNameOf(prim, name);
        m_points += curves.points.size() / 3;
        std::optional<std::vector<ForeignStrands>> groups =
            m_points <= kMostForeignPoints ? strandsOf(curves) : std::nullopt;
        if (!groups || m_curves.groups.size() + groups->size() > kMostNames) {
            m_isBroken = true;
            return;
        }
        for (ForeignStrands& strands : *groups) {
            move(strands, own.toStage);
            m_curves.groups.push_back(std::move(strands));
        }
    }

    static void move(ForeignStrands& strands, const glm::mat4& matrix)
    {
        if (matrix == glm::mat4(1.0F))
            return;
        for (glm::vec3& point : strands.points)
            point = glm::vec3(matrix * glm::vec4(point, 1.0F));
        const float larger = std::cbrt(std::abs(glm::determinant(glm::mat3(matrix))));
        for (StrandLook& look : strands.looks) {
            look.rootWidth *= larger;
            look.tipWidth *= larger;
        }
    }

    const Progress& m_progress;
    UsdStage m_stage;
    double m_size = 1.0;
    double m_done = 0.0;
    ForeignCurves m_curves;
    std::size_t m_points = 0;
    bool m_isStopped = false;
    bool m_isBroken = false;
    bool m_isMovedOddly = false; ///< Hair was found there.
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
    return UsdReader(progress, opener).read(text);
}

} // namespace hairpaint::model
