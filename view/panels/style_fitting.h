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

    /// Previews a style; does nothing while a question is open.
    void show(const PresetPtr& preset, model::StylePart part);
    [[nodiscard]] bool shows() const { return m_edit.active(); }
    /// Applies a style as one undo step, after a question if needed.
    void putOn(const PresetPtr& preset, model::StylePart part);
    void drop();                      ///< Drops a preview.
    void dismiss() { m_edit.drop(); } ///< A question, too, without an answer.

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
    [[nodiscard]] model::StyleUse useOf(const model::Preset& preset, model::StylePart part) const;
    void begin();
    void showStyle(const PresetPtr& preset, const model::StyleUse& use);
    void ask(const PresetPtr& preset, const model::StyleUse& use);
    void commit(const PresetPtr& preset, const model::StyleUse& use);
    void editEnded(); ///< However it ended.

    EditorState& m_state;
    StyleQuestion& m_question;
    std::optional<Asked> m_asked;
    model::EditSession m_edit;                   ///< Of the style that is shown.
    std::optional<model::LayerAddress> m_before; ///< What was active before, while a style is shown.
    /// Groups as a style put them on; as long as they are so, another style may replace them without a question.
    std::map<model::Id, model::HairGroup> m_untouched;
};

} // namespace hairpaint::view
