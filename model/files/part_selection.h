// A user's choice of a character's parts, and what there is to be told of it.
#pragma once

#include "model/files/head_guess.h"
#include "model/values/sentences.h"

#include <QStringList>

namespace hairpaint::model {

/// "body", or "body / skin" where other parts have that name and another material.
[[nodiscard]] QString titleOf(const RiggedMesh& source, std::size_t part);

/// Sets what becomes of each part: as the user says, else as is likely. A name is that of a part or of its material, or
/// its title; capitals do not count. Errors: clauses that name what is not there.
[[nodiscard]] Checked<void> choosePartsBy(RiggedMesh& source, const HeadChoice& choice, const HeadGuess& guess);

struct ChosenHead
{
    RiggedMesh mesh;     ///< As arranged() has it.
    QStringList remarks; ///< Sentences without a full stop: parts without uvs, layouts side by side, shared texels.
};
/// The head made of the parts that were chosen. Fails where there is nothing to paint on.
[[nodiscard]] Checked<ChosenHead> headOfParts(const RiggedMesh& source, bool ownLayout);

} // namespace hairpaint::model
