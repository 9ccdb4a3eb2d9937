// Reading USD text: what is told of BasisCurves is read wherever it stands, and what is none is refused.
#include "model/importing/curve_reader.h"
#include "model/importing/usd_reader.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

const QByteArray kCurves = R"(
        int[] curveVertexCounts = [2, 3]
        point3f[] points = [(0, 0, 0), (0, 1, 0),
                            (1, 0, 0), (1, 1, 0), (1, 2.5e0, -1)] # root first
        uniform token type = "linear"
)";

QByteArray textOf(const QByteArray& curves, const QByteArray& stage = "", const QByteArray& parent = "")
{
    return "#usda 1.0\n(\n    \"made by hand\"\n" + stage +
           ")\n\ndef Xform \"Hair\" (\n    kind = \"component\"\n)\n{\n" + parent +
           "\n    def BasisCurves \"Locks\"\n    {\n" + curves + "    }\n}\n";
}

std::optional<ForeignCurves> read(const QByteArray& text)
{
    Checked<std::optional<ForeignCurves>> curves = readUsdText(text);
    return curves ? std::move(*curves) : std::nullopt;
}

} // namespace

class TestUsdReader : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

private Q_SLOTS:
    void strandsComeAsTheyStand()
    {
        const std::optional<ForeignCurves> curves =
            read(textOf(kCurves, "    doc = \"\"\"two\nlines\"\"\"\n    metersPerUnit = 1\n    upAxis = \"Z\"\n"));
        QVERIFY(curves && curves->groups.size() == 1);
        const ForeignStrands& strands = curves->groups.front();
        QCOMPARE(strands.name, QStringLiteral("Locks"));
        QCOMPARE(strands.count(), std::size_t{2});
        QVERIFY(strands.strand(1).back() == glm::vec3(1.0F, 2.5F, -1.0F));
        QVERIFY(!strands.hasColours);
        QCOMPARE(curves->metresPerUnit, std::optional(1.0F));
        QVERIFY(curves->upAxis == UpAxis::Z);
    }

    void aStageThatTellsNothingIsInCentimetresYUp()
    {
        const std::optional<ForeignCurves> curves = read(textOf(kCurves));
        QVERIFY(curves && curves->metresPerUnit == 0.01F && curves->upAxis == UpAxis::Y);
    }

    void coloursAndWidthsMayBeTheirOwnOrShared_data()
    {
        QTest::addColumn<QByteArray>("look");
        QTest::newRow("of all") << QByteArray("float[] widths = [0.5]\ncolor3f[] primvars:displayColor = [(1, 0, 1)]");
        QTest::newRow("of each curve") << QByteArray("float[] widths = [0.25, 0.5] (\n interpolation = \"uniform\"\n)\n"
                                                     "color3f[] primvars:displayColor = [(0, 0, 0), (1, 0, 1)]");
        QTest::newRow("of each point") << QByteArray(
            "float[] widths = [1, 1, 0.5, 1, 0.5] (\n interpolation = \"vertex\"\n)\ncolor3f[] "
            "primvars:displayColor = [(0,0,0),(0,0,0),(1,0,1),(0,0,0),(1,0,1)]");
    }
    void coloursAndWidthsMayBeTheirOwnOrShared()
    {
        QFETCH(QByteArray, look);
        const std::optional<ForeignCurves> curves = read(textOf(kCurves + look + "\n"));
        QVERIFY(curves && curves->groups.size() == 1 && curves->groups.front().hasColours);
        const StrandLook& second = curves->groups.front().looks[1];
        QCOMPARE(second.rootWidth, 0.5F);
        QCOMPARE(second.tipWidth, 0.5F);
        QVERIFY(glm::distance(second.rootColour, glm::vec3(1.0F, 0.0F, 1.0F)) < 1e-5F);
        QVERIFY(glm::distance(second.tipColour, glm::vec3(1.0F, 0.0F, 1.0F)) < 1e-5F);
    }

    void lightIsEncoded()
    {
        const std::optional<ForeignCurves> curves =
            read(textOf(kCurves + "color3f[] primvars:displayColor = [(0.5, 0, 0)]\n"));
        QVERIFY(curves);
        QVERIFY(std::abs(curves->groups.front().looks[0].rootColour.r - 0.735357F) < 1e-4F);
    }

    void whatMovesAPrimMovesItsCurves()
    {
        const std::optional<ForeignCurves> curves =
            read(textOf(kCurves + "float[] widths = [0.5]\n", "",
                        "double3 xformOp:translate = (10, 0, 0)\nfloat3 xformOp:rotateXYZ = (90, 0, 0)\n"
                        "float3 xformOp:scale = (2, 2, 2)\n"
                        "uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:rotateXYZ\", "
                        "\"xformOp:scale\"]\n"));
        QVERIFY(curves && curves->groups.size() == 1);
        const ForeignStrands& strands = curves->groups.front();
        QVERIFY(glm::distance(strands.strand(0).back(), glm::vec3(10.0F, 0.0F, 2.0F)) < 1e-5F);
        QVERIFY(std::abs(strands.looks[0].rootWidth - 1.0F) < 1e-5F);

        const std::optional<ForeignCurves> matrix =
            read(textOf(kCurves, "",
                        "matrix4d xformOp:transform = ( (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (5, 6, 7, 1) )\n"
                        "uniform token[] xformOpOrder = [\"xformOp:transform\"]\n"));
        QVERIFY(matrix && glm::distance(matrix->groups.front().points[0], glm::vec3(5.0F, 6.0F, 7.0F)) < 1e-5F);
    }

    void whatIsOfNoUseIsPassedOver_data()
    {
        QTest::addColumn<QByteArray>("more");
        QTest::newRow("dictionary") << QByteArray("custom dictionary a = { string b = \"}\" \n int c = 1 }");
        QTest::newRow("asset") << QByteArray("asset a = @./b(.png@");
        QTest::newRow("relation") << QByteArray("rel material:binding = </Looks/Hair>");
        QTest::newRow("connection") << QByteArray("color3f inputs:a.connect = </Looks/Hair.outputs:a>");
        QTest::newRow("nothing") << QByteArray("float[] a = None");
        QTest::newRow("negative") << QByteArray("float a = -1e-5");
        QTest::newRow("a name alone") << QByteArray("custom rel a");
        QTest::newRow("infinite") << QByteArray("float2[] a = [(-inf, nan)]");
        QTest::newRow("text") << QByteArray("string a = 'it\\'s ) # no comment'");
        QTest::newRow("variants") << QByteArray(R"(variantSet "a" = { "b" { def Xform "c" { } } })");
        QTest::newRow("prim") << QByteArray("def Mesh \"a\" { int[] faceVertexCounts = [3] }");
        QTest::newRow("class") << QByteArray("class BasisCurves \"a\" { int[] curveVertexCounts = [7] }");
        QTest::newRow("hidden") << QByteArray(
            "def BasisCurves \"a\" { int[] curveVertexCounts = [2]\npoint3f[] points = "
            "[(0,0,0),(1,1,1)]\ntoken visibility = \"invisible\" }");
    }
    void whatIsOfNoUseIsPassedOver()
    {
        QFETCH(QByteArray, more);
        const std::optional<ForeignCurves> curves = read(textOf(kCurves, "", more + "\n"));
        QVERIFY(curves && curves->groups.size() == 1);
        QCOMPARE(curves->groups.front().count(), std::size_t{2});
    }

    void ofAnimatedCurvesTheFirstMomentIsRead()
    {
        QByteArray moving = kCurves;
        moving.replace("points = [", "points.timeSamples = { 1: [");
        moving.replace("] # root first", "],\n 2: [(9,9,9)], }");
        const std::optional<ForeignCurves> curves = read(textOf(moving));
        QVERIFY(curves && curves->groups.front().strand(1).back() == glm::vec3(1.0F, 2.5F, -1.0F));
    }

    void cubicCurvesAreWhatTheyRunThrough()
    {
        const QByteArray points =
            "int[] curveVertexCounts = [4]\npoint3f[] points = [(0,0,0),(0,1,0),(0,2,0),(0,3,0)]\n";
        const std::optional<ForeignCurves> bezier = read(textOf(points + "uniform token type = \"cubic\"\n"));
        QVERIFY(bezier && bezier->groups.front().points.size() == 2);
        QVERIFY(bezier->groups.front().points.back() == glm::vec3(0.0F, 3.0F, 0.0F));
        const std::optional<ForeignCurves> spline =
            read(textOf(points + "uniform token type = \"cubic\"\nuniform token basis = \"bspline\"\n"));
        QVERIFY(spline && spline->groups.front().points.size() == 2);
        QVERIFY(glm::distance(spline->groups.front().points[0], glm::vec3(0.0F, 1.0F, 0.0F)) < 1e-5F);
    }

    void guidesComeOnlyWhereThereIsNothingElse()
    {
        const QByteArray guides = "def BasisCurves \"Guides\" {\n" + kCurves +
                                  "int[] primvars:groom_guide = [1] (\n interpolation = "
                                  "\"constant\"\n)\n}\n";
        const std::optional<ForeignCurves> both = read(textOf(kCurves, "", guides));
        QVERIFY(both && both->groups.size() == 1 && both->groups.front().name == QLatin1String("Locks"));
        const std::optional<ForeignCurves> alone = read("#usda 1.0\n" + guides);
        QVERIFY(alone && alone->groups.size() == 1);
    }

    void curvesAreReadByTheStandard_data()
    {
        QTest::addColumn<QByteArray>("curves");
        QTest::addColumn<int>("strands");
        QTest::addColumn<float>("lengthOfFirst");
        QTest::addColumn<float>("rootWidth");
        QTest::addColumn<float>("tipWidth");
        const QByteArray five = "int[] curveVertexCounts = [5]\npoint3f[] points = "
                                "[(0,0,0),(0,1,0),(0,2,0),(0,3,0),(0,4,0)]\nuniform token type = \"cubic\"\n";
        const QByteArray seven = "int[] curveVertexCounts = [7]\npoint3f[] points = "
                                 "[(0,0,0),(0,1,0),(0,2,0),(0,3,0),(0,4,0),(0,5,0),(0,6,0)]\n";
        QTest::newRow("pinned b-spline") << five +
                                                "uniform token basis = \"bspline\"\nuniform token wrap = \"pinned\"\n"
                                         << 1 << 4.0F << 0.0F << 0.0F;
        QTest::newRow("Catmull-Rom") << five + "uniform token basis = \"catmullRom\"\n" << 1 << 2.0F << 0.0F << 0.0F;
        QTest::newRow("pinned Catmull-Rom")
            << five + "uniform token basis = \"catmullRom\"\nuniform token wrap = \"pinned\"\n"
            << 1 << 4.0F << 0.0F << 0.0F;
        QTest::newRow("varying widths of a Bezier")
            << seven + "float[] widths = [0.5, 0.25, 0.125] (\n interpolation = \"varying\"\n)\n"
            << 1 << 6.0F << 0.5F << 0.125F;
        QTest::newRow("primvars:widths") << kCurves + "float[] primvars:widths = [0.5]\n" << 2 << 1.0F << 0.5F << 0.5F;
        QTest::newRow("groom_width") << kCurves + "float[] primvars:groom_width = [0.5]\n" << 2 << 1.0F << 0.5F << 0.5F;
        QTest::newRow("indexed") << kCurves + "float[] primvars:widths = [0.1, 0.5] (interpolation = \"uniform\")\n"
                                              "int[] primvars:widths:indices = [1, 1]\n"
                                 << 2 << 1.0F << 0.5F << 0.5F;
        QTest::newRow("a guide among them")
            << kCurves + "int[] primvars:groom_guide = [0, 1] (interpolation = \"uniform\")\n"
            << 1 << 1.0F << 0.0F << 0.0F;
        QTest::newRow("one of one point")
            << QByteArray("int[] curveVertexCounts = [2, 1]\npoint3f[] points = [(0,0,0),(0,1,0),(5,5,5)]\n"
                          "uniform token type = \"linear\"\n")
            << 2 << 1.0F << 0.0F << 0.0F;
    }
    void curvesAreReadByTheStandard()
    {
        QFETCH(QByteArray, curves);
        QFETCH(int, strands);
        QFETCH(float, lengthOfFirst);
        QFETCH(float, rootWidth);
        QFETCH(float, tipWidth);
        const std::optional<ForeignCurves> result = read(textOf(curves));
        QVERIFY(result && result->groups.size() == 1);
        const ForeignStrands& all = result->groups.front();
        QCOMPARE(all.count(), static_cast<std::size_t>(strands));
        QVERIFY(std::abs(glm::distance(all.strand(0).front(), all.strand(0).back()) - lengthOfFirst) < 1e-5F);
        QCOMPARE(all.looks[0].rootWidth, rootWidth);
        QCOMPARE(all.looks[0].tipWidth, tipWidth);
    }

    void groupIdsMakeGroups()
    {
        const std::optional<ForeignCurves> curves =
            read(textOf(kCurves + "int[] primvars:groom_group_id = [0, 1] (interpolation = \"uniform\")\n"));
        QVERIFY(curves && curves->groups.size() == 2);
    }

    void whatIsLeftOutOfAStage_data()
    {
        QTest::addColumn<QByteArray>("prim");
        const QByteArray body = "{\n" + kCurves;
        QTest::newRow("guides") << "def BasisCurves \"a\" " + body + "uniform token purpose = \"guide\"\n}\n";
        QTest::newRow("a proxy") << "def BasisCurves \"a\" " + body + "uniform token purpose = \"proxy\"\n}\n";
        QTest::newRow("inactive") << "def BasisCurves \"a\" (\n active = false\n) " + body + "}\n";
    }
    void whatIsLeftOutOfAStage()
    {
        QFETCH(QByteArray, prim);
        const std::optional<ForeignCurves> curves = read(textOf(kCurves, "", prim));
        QVERIFY(curves && curves->groups.size() == 1);
    }

    void theChosenVariantIsRead()
    {
        const QByteArray text = "#usda 1.0\ndef Xform \"root\" (\n variants = {\n string style = \"long\"\n }\n "
                                "prepend variantSets = \"style\"\n)\n{\n variantSet \"style\" = {\n \"bald\" {\n }\n "
                                "\"long\" {\n def BasisCurves \"hair\"\n {\n" +
                                kCurves + "}\n }\n }\n}\n";
        const std::optional<ForeignCurves> curves = read(text);
        QVERIFY(curves && curves->groups.size() == 1);
        QByteArray other = text;
        other.replace("style = \"long\"", "style = \"bald\"");
        const std::optional<ForeignCurves> bald = read(other);
        QVERIFY(bald && bald->groups.empty());
    }

    void otherFilesOfTheFolderAreFollowed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("groups");
        QTest::addColumn<float>("x"); // The x of the first strand's root.
        const auto prim = [](const QByteArray& metadata, const QByteArray& inside = "") {
            return "#usda 1.0\n(\n metersPerUnit = 1\n)\ndef Xform \"Ann\" (\n " + metadata + "\n) {\n" + inside +
                   "\n}\n";
        };
        const QByteArray moved = "double3 xformOp:translate = (5, 0, 0)\n"
                                 "uniform token[] xformOpOrder = [\"xformOp:translate\"]\n";
        QTest::newRow("default prim") << prim("prepend references = @./hair/both.usda@") << 1 << 1.0F;
        QTest::newRow("a prim") << prim("references = @hair/both.usda@</Other/In>") << 1 << 0.0F;
        QTest::newRow("in a list")
            << prim("references = [@hair/both.usda@</Hair>, @hair/both.usda@</Other> (offset = 1)]") << 2 << 1.0F;
        QTest::newRow("payload") << prim("payload = @@@hair/both.usda@@@</Hair>") << 1 << 1.0F;
        QTest::newRow("moved elsewhere") << prim("payload = @hair/both.usda@", moved) << 1 << 5.0F;
        QTest::newRow("under one that is moved")
            << prim("kind = \"group\"", moved + "def \"b\" ( references = @hair/both.usda@ ) { }\n") << 1 << 6.0F;
        QTest::newRow("layers") << QByteArray("#usda 1.0\n(\n subLayers = [ @hair/both.usda@ ]\n)\n") << 2 << 1.0F;
        QTest::newRow("of the same file")
            << prim("references = </Proto>") + "class \"Proto\" {\n def \"c\" ( references = "
                                               "@hair/both.usda@ ) { }\n}\n"
            << 1 << 1.0F;
        QTest::newRow("a file that refers on") << prim("references = @hair/on.usda@") << 1 << 1.0F;
        QTest::newRow("hidden") << prim("references = @hair/both.usda@", "token visibility = \"invisible\"\n") << 0
                                << 0.0F;
        QTest::newRow("outside the folder") << prim("references = @../outside.usda@") << -1 << 0.0F;
        QTest::newRow("in a circle") << prim("references = @circle.usda@") << -1 << 0.0F;
        QTest::newRow("itself") << prim("references = </Ann>") << -1 << 0.0F;
    }
    void otherFilesOfTheFolderAreFollowed()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, groups);
        QFETCH(float, x);
        const QTemporaryDir folder;
        const auto write = [&folder](const char* name, const QByteArray& content) {
            test::writeBytes(folder.filePath(QLatin1StringView(name)), content);
        };
        QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("ann/hair")));
        const QByteArray curves = "def BasisCurves \"Locks\" {\n" + kCurves + "}\n";
        const QByteArray hair = "def Xform \"Hair\" {\n double3 xformOp:translate = (1, 0, 0)\n"
                                " uniform token[] xformOpOrder = [\"xformOp:translate\"]\n" +
                                curves + "}\n";
        write("ann/hair/both.usda", "#usda 1.0\n(\n defaultPrim = \"Hair\"\n)\n" + hair +
                                        "def Xform \"Other\" {\n def \"In\" {\n" + curves + "}\n}\n");
        write("ann/hair/on.usda", "#usda 1.0\ndef \"On\" ( references = @both.usda@ ) { }\n");
        write("ann/circle.usda", "#usda 1.0\ndef \"a\" ( references = @circle.usda@ ) { }\n");
        write("outside.usda", "#usda 1.0\n" + hair);
        write("ann/first.usda", text);
        const auto read = readUsdText(text, {}, usdFilesBeside(folder.filePath(QStringLiteral("ann/first.usda"))));
        if (groups < 0) {
            QVERIFY(!read);
            return;
        }
        QVERIFY(read && *read);
        QCOMPARE((*read)->groups.size(), static_cast<std::size_t>(groups));
        if (groups > 0)
            QCOMPARE((*read)->groups.front().strand(0).front().x, x);
    }

    void closedCurvesEndWhereTheyBegin_data()
    {
        QTest::addColumn<QByteArray>("basis");
        QTest::addColumn<int>("points");
        QTest::newRow("linear") << QByteArray("token type = \"linear\"") << 7;
        QTest::newRow("bezier") << QByteArray("token basis = \"bezier\"") << 3;
        QTest::newRow("bspline") << QByteArray("token basis = \"bspline\"") << 7;
        QTest::newRow("catmullRom") << QByteArray("token basis = \"catmullRom\"") << 7;
    }
    void closedCurvesEndWhereTheyBegin()
    {
        QFETCH(QByteArray, basis);
        QFETCH(int, points);
        const std::optional<ForeignCurves> curves =
            read(textOf("int[] curveVertexCounts = [6]\n"
                        "point3f[] points = [(0, 0, 0), (0, 1, 0), (1, 2, 0), (2, 2, 0), (2, 1, 0), (1, 0, 0)]\n"
                        "token wrap = \"periodic\"\nuniform " +
                        basis + "\n"));
        QVERIFY(curves && curves->groups.size() == 1);
        const auto strand = curves->groups.front().strand(0);
        QCOMPARE(strand.size(), static_cast<std::size_t>(points));
        QVERIFY(glm::distance(strand.front(), strand.back()) < 1e-6F);
    }

    void whatHoldsOtherCurvesIsNamed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("named");
        QTest::newRow("NURBS") << QByteArray("#usda 1.0\ndef NurbsCurves \"a\" { int[] order = [4] }\n")
                               << QStringLiteral("NURBS");
        QTest::newRow("references") << QByteArray("#usda 1.0\ndef Xform \"a\" ( references = @b.usd@</c> ) { }\n")
                                    << QStringLiteral("b.usd;");
        QTest::newRow("layers") << QByteArray("#usda 1.0\n(\n subLayers = [ @b.usda@ ]\n)\n")
                                << QStringLiteral("b.usda;");
    }
    void whatHoldsOtherCurvesIsNamed()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, named);
        const Checked<std::optional<ForeignCurves>> curves = readUsdText(text);
        QVERIFY(!curves);
        QVERIFY2(curves.error().text.contains(named), qPrintable(curves.error().text));
    }

    void whatIsNoneIsRefused_data()
    {
        QTest::addColumn<QByteArray>("text");
        const QByteArray whole = textOf(kCurves);
        QByteArray counts = whole;
        counts.replace("[2, 3]", "[2, 4]");
        QByteArray fewer = whole;
        fewer.replace("[2, 3]", "[2]");
        QByteArray half = whole;
        half.replace("[2, 3]", "[2.5, 2.5]");
        QByteArray huge = whole;
        huge.replace("[2, 3]", "[2, 1e30]");
        QTest::newRow("another format") << QByteArray("PXR-USDC and more");
        QTest::newRow("no text") << QByteArray("solid");
        QTest::newRow("counts beyond the points") << counts;
        QTest::newRow("points beyond the counts") << fewer;
        QTest::newRow("half a point") << half;
        QTest::newRow("very many") << huge;
        QTest::newRow("cut short") << whole.chopped(4);
        QTest::newRow("cut in an array") << whole.first(whole.indexOf("2.5e0"));
        QTest::newRow("cut in a text") << QByteArray("#usda 1.0\n(\n doc = \"");
        QTest::newRow("too deep") << "#usda 1.0\n" + QByteArray("def \"a\" {").repeated(1000);
        QTest::newRow("an unknown kind of motion")
            << textOf(kCurves, "", "float xformOp:shear = 1\nuniform token[] xformOpOrder = [\"xformOp:shear\"]\n");
        QTest::newRow("moved as nothing says")
            << textOf(kCurves, "", "uniform token[] xformOpOrder = [\"xformOp:scale\"]\n");
        QTest::newRow("no hair") << QByteArray("#usda 1.0\n");
    }
    void whatIsNoneIsRefused()
    {
        QFETCH(QByteArray, text);
        const QString path = m_folder.filePath(QStringLiteral("a.usda"));
        test::writeBytes(path, text);
        const Result<ForeignCurves> curves = readCurves(path);
        QVERIFY(!curves);
        QVERIFY2(test::isOneSentenceNaming(curves.error().message, path), qPrintable(curves.error().message));
    }
};

HAIRPAINT_TEST(TestUsdReader, Core)
#include "test_usd_reader.moc"
