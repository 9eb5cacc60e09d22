/**
 * The image difference evaluator FLIP: how different two images look when one flips between them. Library code.
 *
 * <ul>
 *   <li>Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild, "FLIP: A Difference Evaluator for Alternating
 *       Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2), 2020 (LDR-FLIP).
 *   <li>Andersson, Nilsson, Shirley and Akenine-Möller, "Visualizing Errors in Rendered High Dynamic Range Images",
 *       Eurographics 2021 short papers (HDR-FLIP).
 * </ul>
 */
@NullMarked
package org.daybreak.cli.flip;

import org.jspecify.annotations.NullMarked;
