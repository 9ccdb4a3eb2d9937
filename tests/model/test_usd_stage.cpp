// What several layers of USD say of one prim: the strongest opinion counts, each attribute by itself.
#include "model/importing/curve_import.h"
#include "model/importing/usd_reader.h"
#include "tests/support/test_program.h"

#include <QMap>
#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

using Files = QMap<QString, QByteArray>;

/// One strand along y, of one unit, 0.5 wide.
const QByteArray kLocks = R"(def BasisCurves "Locks" {
    int[] curveVertexCounts = [2]
    point3f[] points = [(0, 0, 0), (0, 1, 0)]
    float[] widths = [0.5] (interpolation = "constant")
    uniform token type = "linear"
}
)";

QByteArray layer(const QByteArray& prims, const QByteArray& stage = "")
{
    return "#usda 1.0\n(\n" + stage + "\n)\n" + prims;
}

Checked<std::optional<ForeignCurves>> readStage(const QByteArray& root, const Files& files)
{
    return readUsdText(root, {}, [&files](const QString& asset, const QString&) -> std::optional<UsdLayer> {
        const auto found = files.find(asset);
        return found == files.end() ? std::nullopt : std::optional(UsdLayer{.text = *found, .path = asset});
    });
}

} // namespace

class TestUsdStage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theStrongestLayerCounts_data()
    {
        QTest::addColumn<QByteArray>("over");
        QTest::addColumn<int>("strands");
        QTest::addColumn<float>("tip"); // Its y.
        QTest::addColumn<float>("width");
        const auto over = [](const QByteArray& inside) { return "over \"Locks\" {\n" + inside + "\n}\n"; };
        QTest::newRow("nothing said") << over("") << 1 << 1.0F << 0.5F;
        QTest::newRow("points") << over("point3f[] points = [(0, 0, 0), (0, 3, 0)]") << 1 << 3.0F << 0.5F;
        QTest::newRow("points of a moment")
            << over("point3f[] points.timeSamples = { 1: [(0, 0, 0), (0, 3, 0)], 2: [(0, 0, 0), (0, 4, 0)] }") << 1
            << 3.0F << 0.5F;
        QTest::newRow("counts and points") << over("int[] curveVertexCounts = [2, 2]\n"
                                                   "point3f[] points = [(0, 0, 0), (0, 2, 0), (1, 0, 0), (1, 1, 0)]")
                                           << 2 << 2.0F << 0.5F;
        QTest::newRow("widths") << over("float[] widths = [0.25]") << 1 << 1.0F << 0.25F;
        QTest::newRow("a primvar in place of an attribute")
            << over("float[] primvars:widths = [0.125]") << 1 << 1.0F << 0.125F;
        QTest::newRow("widths taken away") << over("float[] widths = None") << 1 << 1.0F << 0.0F;
        QTest::newRow("as many as points")
            << over("float[] widths = [0.25, 0.5] (interpolation = \"vertex\")") << 1 << 1.0F << 0.25F;
        QTest::newRow("visibility") << over("token visibility = \"invisible\"") << 0 << 0.0F << 0.0F;
        QTest::newRow("purpose") << over("uniform token purpose = \"guide\"") << 0 << 0.0F << 0.0F;
        QTest::newRow("active") << QByteArray("over \"Locks\" ( active = false ) { }\n") << 0 << 0.0F << 0.0F;
        QTest::newRow("moved") << over("double3 xformOp:translate = (0, 5, 0)\n"
                                       "uniform token[] xformOpOrder = [\"xformOp:translate\"]")
                               << 1 << 6.0F << 0.5F;
        QTest::newRow("another type") << QByteArray("over Xform \"Locks\" { }\n") << 0 << 0.0F << 0.0F;
        QTest::newRow("a child") << over(
                                        "def BasisCurves \"More\" {\n int[] curveVertexCounts = [2]\n point3f[] points "
                                        "= [(0,0,0), (0,7,0)]\n}")
                                 << 2 << 1.0F << 0.5F;
    }
    void theStrongestLayerCounts()
    {
        QFETCH(QByteArray, over);
        QFETCH(int, strands);
        QFETCH(float, tip);
        QFETCH(float, width);
        const Files files{{QStringLiteral("over.usda"), layer(over)},
                          {QStringLiteral("base.usda"), layer(kLocks)},
                          {QStringLiteral("on.usda"), layer(over, "subLayers = [ @base.usda@ ]")}};
        for (const QByteArray& root :
             {layer(over, "subLayers = [ @base.usda@ ]"), layer("", "subLayers = [ @over.usda@, @base.usda@ ]"),
              layer("", "subLayers = [ @on.usda@ ]"),
              layer("def \"Locks\" ( references = @on.usda@</Locks> ) { }\n")}) {
            const auto curves = readStage(root, files);
            QVERIFY2(curves && *curves, root.constData());
            std::size_t all = 0;
            for (const ForeignStrands& group : (*curves)->groups)
                all += group.count();
            QVERIFY2(all == static_cast<std::size_t>(strands), root.constData());
            if (strands == 0)
                continue;
            QCOMPARE((*curves)->groups.front().strand(0).back().y, tip);
            QCOMPARE((*curves)->groups.front().looks[0].rootWidth, width);
        }
    }

    void arcsHaveTheirStrength_data()
    {
        QTest::addColumn<QByteArray>("root");
        QTest::addColumn<float>("tip");
        QTest::addColumn<QString>("name");
        const QByteArray arcs = "def \"A\" (\n inherits = </_class>\n references = @two.usda@</L>\n payload = "
                                "@three.usda@</L>\n variants = { string v = \"x\" }\n) {\n";
        const auto points = [](int y) {
            return "point3f[] points = [(0, 0, 0), (0, " + QByteArray::number(y) + ", 0)]\n";
        };
        const QByteArray variant = "variantSet \"v\" = { \"x\" {\n" + points(8) + "} }\n";
        const auto inherited = [&](const QByteArray& inside) { return "class \"_class\" {\n" + inside + "}\n"; };
        QTest::newRow("local") << layer(arcs + points(9) + variant + "}\n" + inherited(points(7))) << 9.0F << "A";
        QTest::newRow("inherits") << layer(arcs + variant + "}\n" + inherited(points(7))) << 7.0F << "A";
        QTest::newRow("variant") << layer(arcs + variant + "}\n" + inherited("")) << 8.0F << "A";
        QTest::newRow("reference") << layer(arcs + "}\n") << 2.0F << "A";
        QTest::newRow("the first of two references")
            << layer("def \"A\" ( references = [@three.usda@</L>, @two.usda@</L>] ) { }\n") << 3.0F << "A";
        QTest::newRow("put before by another layer")
            << layer("over \"A\" ( prepend references = @three.usda@</L> ) { }\n", "subLayers = [ @first.usda@ ]")
            << 3.0F << "A";
        QTest::newRow("put behind by another layer")
            << layer("over \"A\" ( append references = @three.usda@</L> ) { }\n", "subLayers = [ @first.usda@ ]")
            << 2.0F << "A";
        QTest::newRow("in place of another layer's")
            << layer("over \"A\" ( references = @three.usda@</L> ) { }\n", "subLayers = [ @first.usda@ ]") << 3.0F
            << "A";
        QTest::newRow("taken away by another layer")
            << layer("over \"A\" ( delete references = @two.usda@</L>\n append references = @three.usda@</L> ) { }\n",
                     "subLayers = [ @first.usda@ ]")
            << 3.0F << "A";
        QTest::newRow("a child's own over one above")
            << layer("def \"World\" ( references = @world.usda@</W> ) {\n over \"A\" ( references = @three.usda@</L> ) "
                     "{ }\n}\n")
            << 3.0F << "A";
        QTest::newRow("what is above it reaches it")
            << layer("def \"World\" ( references = @world.usda@</W> ) {\n over \"A\" {\n" + points(6) + " }\n}\n")
            << 6.0F << "A";
        QTest::newRow("a variant that the layer above chooses")
            << layer("def \"A\" ( references = @variants.usda@</L>\n variants = { string v = \"long\" } ) { }\n")
            << 30.0F << "A";
        QTest::newRow("a variant that its own layer chooses")
            << layer("def \"A\" ( references = @variants.usda@</L> ) { }\n") << 1.0F << "A";
        QTest::newRow("a variant that refers on")
            << layer("def \"A\" ( variants = { string v = \"x\" } ) {\n variantSet \"v\" = { \"x\" ( references = "
                     "@two.usda@</L> ) { } }\n}\n")
            << 2.0F << "A";
        QTest::newRow("a path through a reference")
            << layer("def \"B\" ( references = @deep.usda@</D/A> ) { }\n") << 2.0F << "B";
        QTest::newRow("a class that another layer changes")
            << layer("over \"_class\" {\n" + points(5) + "}\n", "subLayers = [ @classes.usda@ ]") << 5.0F << "A";
        QTest::newRow("what it inherits in its own file")
            << layer("def \"A\" ( references = @classes.usda@</A> ) { }\n") << 4.0F << "A";
        QTest::newRow("where the parent does not count")
            << layer("def Xform \"P\" {\n double3 xformOp:translate = (0, 100, 0)\n uniform token[] xformOpOrder = "
                     "[\"xformOp:translate\"]\n def \"A\" ( references = @two.usda@</L> ) {\n uniform token[] "
                     "xformOpOrder = [\"!resetXformStack!\"]\n }\n}\n")
            << 2.0F << "A";
    }
    void arcsHaveTheirStrength()
    {
        QFETCH(QByteArray, root);
        QFETCH(float, tip);
        QFETCH(QString, name);
        const auto locks = [](int y, const QByteArray& more = "") {
            return "def BasisCurves \"L\" {\n int[] curveVertexCounts = [2]\n point3f[] points = [(0, 0, 0), (0, " +
                   QByteArray::number(y) + ", 0)]\n" + more + "}\n";
        };
        const Files files{
            {QStringLiteral("two.usda"), layer(locks(2))},
            {QStringLiteral("three.usda"), layer(locks(3))},
            {QStringLiteral("first.usda"), layer("def \"A\" ( references = @two.usda@</L> ) { }\n")},
            {QStringLiteral("world.usda"), layer("def \"W\" {\n def \"A\" ( references = @two.usda@</L> ) { }\n}\n")},
            {QStringLiteral("deep.usda"), layer("def \"D\" ( references = @world.usda@</W> ) { }\n")},
            {QStringLiteral("classes.usda"),
             layer(
                 "class BasisCurves \"_class\" {\n int[] curveVertexCounts = [2]\n point3f[] points = [(0, 0, 0), (0, "
                 "4, 0)]\n}\ndef \"A\" ( inherits = </_class> ) { }\n")},
            {QStringLiteral("variants.usda"),
             layer("def BasisCurves \"L\" ( variants = { string v = \"short\" } ) {\n int[] curveVertexCounts = [2]\n "
                   "variantSet \"v\" = { \"short\" { point3f[] points = [(0, 0, 0), (0, 1, 0)]\n }\n \"long\" { "
                   "point3f[] points = [(0, 0, 0), (0, 30, 0)]\n } }\n}\n")}};
        const auto curves = readStage(root, files);
        QVERIFY(curves && *curves);
        QCOMPARE((*curves)->groups.size(), std::size_t{1});
        QCOMPARE((*curves)->groups.front().strand(0).back().y, tip);
        QCOMPARE((*curves)->groups.front().name, name);
        QVERIFY((*curves)->unread.isEmpty());
    }

    void whatAParentTellsReachesItsCurves_data()
    {
        QTest::addColumn<QByteArray>("parent");
        QTest::addColumn<QByteArray>("own");
        QTest::addColumn<int>("groups");
        QTest::addColumn<float>("green");
        QTest::newRow("a colour") << QByteArray("color3f[] primvars:displayColor = [(0, 1, 0)]") << QByteArray() << 1
                                  << 1.0F;
        QTest::newRow("its own colour") << QByteArray("color3f[] primvars:displayColor = [(0, 1, 0)]")
                                        << QByteArray("color3f[] primvars:displayColor = [(1, 0, 0)]") << 1 << 0.0F;
        QTest::newRow("purpose") << QByteArray("uniform token purpose = \"proxy\"") << QByteArray() << 0 << 0.0F;
        QTest::newRow("its own purpose") << QByteArray("uniform token purpose = \"proxy\"")
                                         << QByteArray("uniform token purpose = \"render\"") << 1 << 0.0F;
        QTest::newRow("not seen") << QByteArray("token visibility = \"invisible\"")
                                  << QByteArray("token visibility = \"inherited\"") << 0 << 0.0F;
    }
    void whatAParentTellsReachesItsCurves()
    {
        QFETCH(QByteArray, parent);
        QFETCH(QByteArray, own);
        QFETCH(int, groups);
        QFETCH(float, green);
        QByteArray locks = kLocks;
        locks.replace("uniform token type", own + "\nuniform token type");
        const auto curves = readStage(layer("def Xform \"P\" {\n" + parent + "\n" + locks + "}\n"), {});
        QVERIFY(curves && *curves);
        QCOMPARE((*curves)->groups.size(), static_cast<std::size_t>(groups));
        if (groups > 0)
            QCOMPARE((*curves)->groups.front().looks[0].rootColour.g, green);
    }

    void whatOnlyOverridesIsNone()
    {
        QByteArray over = kLocks;
        over.replace("def BasisCurves", "over BasisCurves");
        const auto curves = readStage(layer(over), {});
        QVERIFY(curves && *curves && (*curves)->groups.empty());
        const auto without = readStage(layer(over, "subLayers = [ @gone.usda@ ]"), {});
        QVERIFY(!without && without.error().text.contains(QStringLiteral("gone.usda;")));
    }

    void whatIsNotReadIsNamedBesideTheRest()
    {
        const auto curves =
            readStage(layer(kLocks + "def \"Body\" ( payload = @body.usdc@ ) { }\n"
                                     "def \"Other\" ( references = </Nowhere> ) { }\n"
                                     "def \"Hidden\" ( references = @hidden.usda@\n active = false ) { }\n"),
                      {});
        QVERIFY(curves && *curves);
        QCOMPARE((*curves)->groups.size(), std::size_t{1});
        const QStringList names{QStringLiteral("body.usdc"), QStringLiteral("/Nowhere")};
        QCOMPARE((*curves)->unread, names);
        QVERIFY(unreadFiles((*curves)->unread).contains(QStringLiteral("body.usdc, /Nowhere;")));
    }

    void whatRefersToItselfManyTimesEnds_data()
    {
        QTest::addColumn<QByteArray>("text");
        const QByteArray self = QByteArray("</A>, ").repeated(12);
        QTest::newRow("itself") << layer("def \"A\" ( references = [" + self + "] ) { }\n");
        QTest::newRow("from below") << layer("def \"A\" {\n def \"B\" ( references = [" + self +
                                             "] ) { }\n def \"C\" ( "
                                             "references = [" +
                                             self + "] ) { }\n}\n");
        QTest::newRow("very many") << layer("def \"A\" ( references = [" + self.repeated(200) + "] ) { }\n");
    }
    void whatRefersToItselfManyTimesEnds()
    {
        QFETCH(QByteArray, text);
        QVERIFY(!readStage(text, {}));
    }
};

HAIRPAINT_TEST(TestUsdStage, Core)
#include "test_usd_stage.moc"
