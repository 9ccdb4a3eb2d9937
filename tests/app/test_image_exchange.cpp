// Images as maps and maps as images, by the window's menus and dropped on it.
#include "tests/app/exchange_fixture.h"
#include "tests/support/test_program.h"

namespace hairpaint::app {

class TestImageExchange : public QObject, private ExchangeFixture
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareDialogs(); }
    void cleanup() { closeWindow(); }

    void anImageBecomesALayerOfTheMap_data() { menuOrDrop(); }
    void anImageBecomesALayerOfTheMap()
    {
        QFETCH(bool, dropped);
        open(model::newProject());
        const QByteArray before = savedBytes("image-before.hairpaint");
        editor().target().setMap(model::MapKind::Length);
        const std::size_t count = layers().size();
        bring(halfImage("fringe.png", Qt::blue), "file.loadImage", dropped);
        QTRY_COMPARE_WITH_TIMEOUT(layers().size(), count + 1, kPatienceMs);
        const model::Layer& layer = layers().back();
        QCOMPARE(layer.name, QStringLiteral("fringe"));
        const int size = layer.raster.size();
        QCOMPARE(layer.raster.texel(size / 4, size / 2), (sim::Texel{65535, 65535, 0, 0}));
        QCOMPARE(layer.raster.texel(size * 3 / 4, size / 2), (sim::Texel{0, 65535, 0, 0}));
        QCOMPARE(stack().count(), 1);
        QCOMPARE(stack().undoText(), QStringLiteral("Load fringe.png into Length"));
        session().document().undo();
        QVERIFY(savedBytes("image-after.hairpaint") == before);
        QVERIFY2(m_answers->said.isEmpty(), qPrintable(m_answers->said.join(QLatin1Char('|'))));
    }

    void aGreyImageIsTheValueItself()
    {
        open(model::newProject());
        editor().target().setMap(model::MapKind::Gel);
        const auto left = [this] {
            const sim::TiledRaster& raster = layers().back().raster;
            return int(raster.texel(raster.size() / 4, raster.size() / 2)[0]);
        };
        m_answers->file = halfImage("grey.png", QColor(51, 51, 51));
        trigger("file.loadGrey");
        QCOMPARE(stack().count(), 1);
        QVERIFY2(std::abs(left() - 65535 / 5) < 300, qPrintable(QString::number(left())));
        const int asTold = left();
        trigger("file.loadImage"); // Gel's scale holds no greys: what is grey can be the value alone.
        QCOMPARE(stack().count(), 2);
        QCOMPARE(left(), asTold);
    }

    void anImageOfAnotherSizeIsSaidToBeResampled()
    {
        open(model::newProject());
        const int size = session().document().committed().groups.front().map(model::MapKind::Density).size;
        for (const int side : {size / 2, size}) {
            m_done.clear();
            QImage image(side, side, QImage::Format_RGB32);
            image.fill(Qt::black);
            m_answers->file = path("square.png");
            QVERIFY(image.save(m_answers->file));
            trigger("file.loadGrey");
            QCOMPARE(m_done.isEmpty(), side == size);
        }
        QVERIFY(m_answers->said.isEmpty());
    }

    void withoutAGroupThereIsNoMapToSaveOrLoad()
    {
        model::Project project = model::newProject();
        project.groups.clear();
        open(std::move(project));
        m_answers->file = halfImage("alone.png", Qt::black);
        trigger("file.loadGrey");
        QCOMPARE(m_answers->said.size(), 1);
        m_answers->file = path("no-map.png");
        trigger("file.saveImage");
        QCOMPARE(m_answers->said.size(), 2);
        QVERIFY(!QFile::exists(path("no-map.png")));
        QCOMPARE(stack().count(), 0);
    }

    void whatIsOnlyShownIsNoPartOfASavedMap()
    {
        open(model::newProject());
        model::Document& document = session().document();
        const model::Id group = document.committed().groups.front().id;
        const model::Id layer = document.committed().groups.front().map(model::MapKind::Density).layers.front().id;
        editor().target().setMap(model::MapKind::Density);
        model::EditSession shown;
        document.show(shown, {.policy = model::EditPolicy::Drop},
                      {.aspect = model::Change::Aspect::LayerList, .group = group, .map = model::MapKind::Density},
                      [=](model::Project& project) {
                          sim::TiledRaster& raster = project.layer(group, model::MapKind::Density, layer)->raster;
                          for (int tile = 0; tile < raster.tileCount(); ++tile)
                              raster.setUniform(tile, {65535, 65535});
                      });
        m_answers->file = path("density.png");
        trigger("file.saveImage");
        const QImage saved(path("density.png"));
        QCOMPARE(saved.pixelColor(saved.width() / 2, saved.height() / 2), QColor(Qt::white));
    }

    void aMapGoesOutAsAnImageAndComesBackTheSame()
    {
        open(model::newProject());
        key(Qt::Key_2);
        key(Qt::Key_G);
        drag(m_window->paintView(), paintPoint(0.5F, 0.65F), paintPoint(0.5F, 0.35F));
        QCOMPARE(stack().count(), 1);
        const auto shown = [this] {
            return session().document().resolved(editor().target().group(), editor().target().map());
        };
        const std::shared_ptr<const sim::TiledRaster> before = shown();
        m_answers->file = path("length"); // The ending is added.
        trigger("file.saveImage");
        QCOMPARE(m_done, QStringList(QStringLiteral("length.png written")));
        QCOMPARE(QImage(path("length.png")).size(), QSize(before->size(), before->size()));
        QCOMPARE(stack().count(), 1);

        drop(path("length.png"));
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 2, kPatienceMs);
        QCOMPARE(shown()->size(), before->size());
        for (int y = 0; y < before->size(); y += 7)
            for (int x = 0; x < before->size(); x += 7)
                QVERIFY(std::abs(int(shown()->texel(x, y)[0]) - int(before->texel(x, y)[0])) <= 1);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestImageExchange, Widgets)
#include "test_image_exchange.moc"
