// Previews a style while it is pointed at and applies it, after a question if it would replace groups that it is not
// evidently about.
#pragma once

#include "model/styles/style_use.h"
#include "view/editing/editor_state.h"
#include "view/panels/style_shelf.h"

#include <QObject>

#include <map>
#include <optional>

namespace hairpaint::view {

class StyleQuestion;

/// What is shown is what putting it on would do, and gives the same bytes. GUI thread.
class StyleFitting : public QObject
{
    Q_OBJECT
public:
    StyleFitting(EditorState& state, StyleQuestion& question, QObject* parent);

    /// 0..1: how much of a style is shown and put on from now on, as in model::StyleUse. Where the hair is still as the
    /// last style left it, that style is shown anew with as much of it, over the hair that was there before.
    void setFraction(double fraction);
    void letGo();                           ///< The last style stays as it is: setFraction() is of the next one.
    void keepFraction();                    ///< What setFraction() shows becomes one undo step.
    void takeFractionBack(double fraction); ///< Drops what setFraction() shows; `fraction` is in force again.
    /// Previews a style; does nothing while a question is open.
    void show(const PresetPtr& preset, model::StylePart part);
    [[nodiscard]] bool shows() const { return m_edit.active(); }
    /// Applies a style as one undo step, after a question if needed.
    void putOn(const PresetPtr& preset, model::StylePart part);
    void drop();                      ///< Drops a preview.
    void dismiss() { m_edit.drop(); } ///< Drops a preview and, without an answer, a question.

Q_SIGNALS:
    void failed(const QString& message); ///< The style has nothing for this head.
    void kept();                         ///< A style was put on.
    void asking();                       ///< The question must be seen now.

private:
    struct Asked
    {
        PresetPtr preset;
        model::StyleUse use;
    };
    /// What a style was put on over, and what came of it.
    struct Kept
    {
        PresetPtr preset;
        model::StyleUse use;
        std::vector<model::HairGroup> groupsBefore, groupsAfter;
        std::vector<model::Worn> wornBefore, wornAfter;
    };
    void remember(); ///< Notes in m_kept what the style left behind.
    [[nodiscard]] model::StyleUse useOf(const model::Preset& preset, model::StylePart part) const;
    void begin();
    void showStyle(const PresetPtr& preset, const model::StyleUse& use);
    void ask(const PresetPtr& preset, const model::StyleUse& use);
    void commit(const PresetPtr& preset, const model::StyleUse& use);
    void editEnded(); ///< Called however m_edit ended.

    EditorState& m_state;
    StyleQuestion& m_question;
    std::optional<Asked> m_asked;
    double m_fraction = 1.0;
    std::optional<Kept> m_kept;
    bool m_mixes = false;                        ///< setFraction() shows the last style.
    model::EditSession m_edit;                   ///< The edit that shows a style.
    std::optional<model::LayerAddress> m_before; ///< What was active before, while a style is shown.
    /// Groups as a style put them on; as long as they are so, another style may replace them without a question.
    std::map<model::Id, model::HairGroup> m_untouched;
};

} // namespace hairpaint::view
