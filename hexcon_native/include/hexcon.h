/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * @file hexcon.h
 * HexCon's core: hexahedral meshes whose boundary is exactly a given closed quad surface.
 *
 * Conventions, everywhere in this header:
 *  - ids are 0-based int32_t; counts are size_t; coordinates are double in the user's unit.
 *  - a surface is `points` [point_count][3] and `quads` [quad_count][4], row-major, each quad
 *    counter-clockwise seen from outside.
 *  - a hex mesh is `points` [point_count][3] and `hexes` [hex_count][8] in VTK_HEXAHEDRON order,
 *    positively oriented.
 *  - arrays are the caller's; the core copies what it keeps. No array may be NULL unless said so.
 *    An array must not change while a call reads it, by the progress callback or another thread:
 *    its ids are checked once.
 *  - every call returns a status; the words and the offending ids are in the context.
 *  - nothing is printed, nothing aborts, there is no global state: contexts may be used from
 *    different threads at once, one context from one thread at a time.
 */
#ifndef HEXCON_H
#define HEXCON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Version of this header; hexcon_version() tells that of the library. CMake, pkg-config, Python's
 * `__version__` take it from here. While it begins with 0, a minor version may change calls. */
#define HEXCON_VERSION "0.2.0"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef HEXCON_SHARED /* only while a shared library is built, which hides all other names */
#pragma GCC visibility push(default)
#endif

/** HEXCON_VERSION as the library was built; static text. */
const char *hexcon_version(void);

/**
 * The faults: name, what it means, what hexcon_context_elements lists ("": nothing), and what the
 * user can do. All that tells of faults is made from these rows: hexcon_status, the Python enum
 * `hexcon_native.ErrorCode`, its stub and docs/errors.md. Numbers are promises: new rows go to the
 * end.
 */
#define HEXCON_STATUSES(ROW)                                                                       \
  ROW(OUT_OF_MEMORY, "there is not enough memory", "",                                             \
      "use a coarser surface, or a machine with more memory")                                      \
  ROW(CANCELLED, "the caller, or the progress callback, cancelled", "",                            \
      "call again if it was not meant")                                                            \
  ROW(BAD_ARGUMENT,                                                                                \
      "an option is out of its range, unknown, or not for this method; or an array is "            \
      "missing",                                                                                   \
      "", "give what the message asks for")                                                        \
  ROW(TOO_LARGE, "a count is above what 32-bit ids hold", "",                                      \
      "mesh in parts, or with a coarser surface")                                                  \
  ROW(WRONG_SHAPE,                                                                                 \
      "an array does not have the rows and columns that are asked for (raised by "                 \
      "bindings)",                                                                                 \
      "", "reshape it: points (., 3), quads (., 4), hexes (., 8) or (., 20)")                      \
  ROW(WRONG_TYPE, "an array holds the wrong kind of number (raised by bindings)", "",              \
      "give real numbers for coordinates and integers for ids")                                    \
  ROW(EMPTY, "there are no quads, or no hexes", "", "check what was read or selected")             \
  ROW(INDEX_OUT_OF_RANGE, "an id names a point that does not exist", "quads, or hexes",            \
      "count ids from 0, and give every point that they name")                                     \
  ROW(REPEATED_VERTEX, "a quad or a hex names one point twice", "quads, or hexes",                 \
      "remove what is collapsed; a triangle written as a quad is none")                            \
  ROW(NOT_FINITE, "a coordinate is NaN, infinite or beyond 1e100", "points",                       \
      "mend the coordinates, or the unit")                                                         \
  ROW(UNUSED_POINT, "no quad uses a point", "points", "drop points that are not the surface's")    \
  ROW(NOT_CLOSED, "the surface is open: some edges have one quad only", "quads at open edges",     \
      "close the surface, and merge points that lie on each other")                                \
  ROW(NON_MANIFOLD_EDGE, "more than two quads meet at an edge", "quads at such edges",             \
      "remove inner walls and doubled quads, or mesh the bodies one by one")                       \
  ROW(NON_MANIFOLD_VERTEX, "several fans of quads meet at one point", "points",                    \
      "part the bodies that touch there, or give each its own point")                              \
  ROW(NOT_ORIENTABLE, "the surface is one-sided, as a Moebius band is",                            \
      "two quads that close a one-sided band", "give the boundary of a body")                      \
  ROW(INCONSISTENT_ORIENTATION, "some quads are turned against their neighbours",                  \
      "the quads turned against the majority", "reverse the order of the listed quads' corners")   \
  ROW(SEVERAL_COMPONENTS, "the surface bounds several bodies",                                     \
      "one quad of each body's outer shell", "mesh the bodies one by one")                         \
  ROW(ODD,                                                                                         \
      "the number of quads is odd, so that no hex mesh exists; or that of a single "               \
      "shell, and none is made",                                                                   \
      "one quad of each odd shell, if there are several shells", "change the size a little")       \
  ROW(NOT_BIPARTITE,                                                                               \
      "the points cannot be coloured black and white along edges, which this method needs",        \
      "points of a closed path of an odd number of edges, in order",                               \
      "change the size so that the path becomes even, or take another method")                     \
  ROW(NO_PAIRING, "the quads cannot all be paired with neighbours", "quads left over",             \
      "change the size a little, or give pairs")                                                   \
  ROW(BAD_PAIRING, "a given pair names a quad twice, or two quads without a common edge",          \
      "quads of such pairs", "pair neighbours, each quad once")                                    \
  ROW(SELF_CROSSING, "a dual loop still crosses itself, which this method cannot take",            \
      "quads that a loop passes twice", "pair more quads: pairing \"all\" or \"fewest\"")          \
  ROW(NO_SIDES, "a family of dual loops has no two sides, because of a hole through the body",     \
      "points of a closed path that crosses the family an odd number of times, in order",          \
      "take another method, or other quads")                                                       \
  ROW(NOT_A_BALL,                                                                                  \
      "the body has holes through it, or cavities, with which this method cannot deal, "           \
      "or only with tetrahedra that were not found",                                               \
      "", "take a method that can, such as diced or cells, or give a mesher of tetrahedra")        \
  ROW(UNFILLABLE_QUAD, "on some quads no hex with a positive Jacobian can stand", "those quads",   \
      "round off or refine the surface there")                                                     \
  ROW(NOT_STAR_SHAPED,                                                                             \
      "no point inside sees the whole surface, and there are no tetrahedra for its inside", "",    \
      "give a mesher of tetrahedra, or a finer surface")                                           \
  ROW(NOT_SWEPT, "the surface is not that of a sweep", "quads where the best attempt failed",      \
      "take another method, or quads of a sweep")                                                  \
  ROW(NO_SHEETS,                                                                                   \
      "the dual loops cannot be taken away until a cube, or a core that can be filled, "           \
      "is left",                                                                                   \
      "quads of the core, as far as they are the surface's", "take another method")                \
  ROW(NOT_DICED, "the quads are no subdivision of a coarser surface",                              \
      "quads that do not fit the subdivision that fits best",                                      \
      "take another method, or subdivided quads")                                                  \
  ROW(NOT_CERTIFIED, "a mesh was made, but it could not be proved",                                \
      "hexes that are not proved positive",                                                        \
      "use a finer surface, or allow uncertified meshes to look at it")                            \
  ROW(OUT_OF_TIME, "the time budget ran out before there was a mesh", "",                          \
      "allow more time, or mesh with larger quads")                                                \
  ROW(NO_SMALL_FILLING,                                                                            \
      "the table of small fillings has none for these quads: they are more than 16, or "           \
      "of a class that it lacks",                                                                  \
      "two quads with two opposite corners in common", "take another method")                      \
  ROW(NO_ROTATIONS, "no rotations of edges lead to dual loops that can be taken away", "",         \
      "take another method")                                                                       \
  ROW(NO_HEX_MESH,                                                                                 \
      "no hex mesh exists: closed paths of an odd number of edges bound a surface inside",         \
      "points of those paths, in order", "change the size so that the paths become even")          \
  ROW(SELF_INTERSECTING,                                                                           \
      "the surface crosses or touches itself, or comes too near to itself to tell, so that it "    \
      "bounds no solid",                                                                           \
      "quads, pair after pair; twice the same: it is folded",                                      \
      "use a smaller size where walls are thin or radii small; merge points that stand twice")     \
  ROW(BAD_PROPOSAL,                                                                                \
      "the proposed hexes are no conforming mesh, or their boundary is not the surface",           \
      "hexes that meet improperly, or inner points of no hex",                                     \
      "propose hexes that have exactly the quads, outward, for their boundary")

typedef enum hexcon_status {
  HEXCON_OK = 0,
#define HEXCON_STATUS_VALUE(name, meaning, elements, advice) HEXCON_##name,
  HEXCON_STATUSES(HEXCON_STATUS_VALUE)
#undef HEXCON_STATUS_VALUE
      HEXCON_STATUS_COUNT
} hexcon_status;

/** A fault in words; static texts, never NULL, "" of HEXCON_OK but for its name. */
typedef struct hexcon_status_facts {
  const char *name;     /**< without its prefix, e.g. "NOT_CLOSED" */
  const char *meaning;  /**< one sentence, without its full stop */
  const char *elements; /**< what the ids of hexcon_context_elements are; "": none are listed */
  const char *advice;   /**< what the user can do */
} hexcon_status_facts;

/** @return NULL for values that do not exist */
const hexcon_status_facts *hexcon_status_info(int status);

/** Name of a status without its prefix, e.g. "NOT_CLOSED"; NULL for values that do not exist. */
const char *hexcon_status_name(int status);

/* ------------------------------------------------------------------------------------ context */

/** Carries the last error, the progress callback and the allocator of a series of calls. */
typedef struct hexcon_context hexcon_context;

/**
 * Called now and then during long work, always from the calling thread.
 * @param stage     what is being done, valid during the call. As far as there is a mesh, ", " and
 *                  what is known of it follow: "optimisation, 64 hexes, worst scaled Jacobian
 *                  0.312", or "untangling, 3 of 64 hexes inverted"
 * @param fraction  of that stage, in [0, 1]; told several times where a stage has long parts
 * @return false to cancel: the running call ends with HEXCON_CANCELLED
 */
typedef bool (*hexcon_progress)(void *user, const char *stage, double fraction);

/** A stage of work: its name, and the words that people see. Static texts. */
typedef struct hexcon_stage_facts {
  const char *name;
  const char *words;
} hexcon_stage_facts;

/** The stages that hexcon_progress tells of. @param row from 0 on @return NULL beyond the last */
const hexcon_stage_facts *hexcon_progress_stage(size_t row);

/** Replaceable allocator: as realloc(3); size 0 frees and returns NULL. */
typedef void *(*hexcon_reallocate)(void *user, void *memory, size_t size);

/** @return NULL when out of memory. */
hexcon_context *hexcon_context_new(void);
/** @param reallocate  NULL for the C library's */
hexcon_context *hexcon_context_new_with(hexcon_reallocate reallocate, void *user);
/** Frees the context; results made with it must be freed before. NULL is allowed. */
void hexcon_context_free(hexcon_context *context);
/** @param progress  NULL for none */
void hexcon_context_set_progress(hexcon_context *context, hexcon_progress progress, void *user);
/** Words for the last error, valid until the next call with this context; "" if there was none. */
const char *hexcon_context_message(const hexcon_context *context);
/** Offending ids of the last error, at most 1000. @param elements receives the array. */
size_t hexcon_context_elements(const hexcon_context *context, const int32_t **elements);

/* ------------------------------------------------------------------------------------ surface */

/** Whether a hex mesh with a given boundary exists, as a complex: its shape is another question. */
typedef enum hexcon_fillable {
  HEXCON_FILLABLE_UNKNOWN = 0,
  HEXCON_FILLABLE_YES,
  HEXCON_FILLABLE_NO,
  HEXCON_FILLABLE_COUNT
} hexcon_fillable;

/** Facts of a surface. */
typedef struct hexcon_surface_report {
  size_t quad_count, point_count, edge_count, component_count;
  size_t cavity_count; /**< components that lie inside an odd number of others */
  int64_t euler;       /**< points - edges + quads */
  int64_t genus;       /**< sum over the components */
  bool even;           /**< even number of quads in every component */
  bool bipartite;      /**< points can be 2-coloured along edges */
  /** Source: Erickson, Efficiently hex-meshing things with topology (2014): YES if the quads are
   * even in number and no odd closed path of edges, or sum of such, bounds inside. UNKNOWN of
   * several bodies with an odd shell, and where the closed paths are too many, or too near to each
   * other, to tell. Of a surface that crosses itself it is UNKNOWN, or means nothing. */
  hexcon_fillable fillable;
  bool oriented;    /**< quads face out of the solid as given; false: all shells, or some, face into
                       it, and are turned */
  bool convex;      /**< no edge is concave by more than the warp of its quads */
  bool star_shaped; /**< star_center sees every corner triangle from inside */
  double star_center[3]; /**< deepest such point, if star_shaped */
  double star_margin;    /**< its distance to the nearest corner plane; < 0 if there is none */
  double volume;         /**< enclosed by the bilinear quads, without the cavities; positive */
  size_t loop_count, self_crossing_count;
} hexcon_surface_report;

/**
 * Check a surface and report its facts. Linear in quad_count (expected, for the star centre); of
 * several shells, linear in the quads of those round each other; where the points cannot be
 * 2-coloured, near-linear times the square of the genus.
 * @return HEXCON_OK, or the first fault of EMPTY, TOO_LARGE, INDEX_OUT_OF_RANGE, NOT_FINITE,
 *         REPEATED_VERTEX, UNUSED_POINT, NON_MANIFOLD_EDGE, NOT_CLOSED, NOT_ORIENTABLE,
 *         INCONSISTENT_ORIENTATION, NON_MANIFOLD_VERTEX; OUT_OF_MEMORY, CANCELLED.
 */
hexcon_status hexcon_check_surface(hexcon_context *context, const double *points,
                                   size_t point_count, const int32_t *quads, size_t quad_count,
                                   hexcon_surface_report *report);

/**
 * Turn quads whose corners run in any sense until they face out of the solid: out of its bodies,
 * and into its cavities. Those that are turned have their corners reversed. Cost: as
 * hexcon_check_surface without the star centre and the colouring.
 * @param quads  [quad_count][4], in and out; as they were after an error
 * @param body_count, cavity_count  receive the components that bound bodies, and cavities
 * @return the faults of hexcon_check_surface but for INCONSISTENT_ORIENTATION
 */
hexcon_status hexcon_orient_surface(hexcon_context *context, const double *points,
                                    size_t point_count, int32_t *quads, size_t quad_count,
                                    size_t *body_count, size_t *cavity_count);

/** Whether a surface crosses and touches itself nowhere. */
typedef enum hexcon_embedded {
  HEXCON_EMBEDDED_UNKNOWN = 0,
  HEXCON_EMBEDDED_YES,
  HEXCON_EMBEDDED_NO,
  HEXCON_EMBEDDED_COUNT
} hexcon_embedded;

/** More pairs than these are not looked for. */
#define HEXCON_MAX_EMBEDDING_PAIRS 1000

/** What is proved of the places of a surface's quads. */
typedef struct hexcon_embedding {
  hexcon_embedded embedded;
  size_t pair_count;
  /** [pair_count][2] quads, the lower id first, ascending. NO: they cross or touch where they do
   * not share points; the same twice: a flat quad that is not convex, so that its patch is folded.
   * UNKNOWN: they touch, or come too near to each other to tell. */
  int32_t *pairs;
  size_t twin_count; /**< points at a place where another one stands; then pairs are theirs alone */
  char reason[160];  /**< words for what is not YES; "" if it is */
} hexcon_embedding;

/**
 * Prove that a surface crosses and touches itself nowhere: each quad is the bilinear patch on its
 * corners, and two of them have in common the points and edges that they share by ids, nothing
 * else. Decided exactly for quads in planes and points that coincide; for warped ones down to some
 * 10^-14 of their size, below that it may be UNKNOWN. Expected n log n.
 * @param embedding  filled; free with hexcon_embedding_free
 * Errors: EMPTY, TOO_LARGE, INDEX_OUT_OF_RANGE, NOT_FINITE, REPEATED_VERTEX, UNUSED_POINT,
 * OUT_OF_MEMORY, CANCELLED.
 */
hexcon_status hexcon_surface_embedding(hexcon_context *context, const double *points,
                                       size_t point_count, const int32_t *quads, size_t quad_count,
                                       hexcon_embedding *embedding);
void hexcon_embedding_free(hexcon_context *context, hexcon_embedding *embedding);

/** Dual loops of a surface: loop i passes quads[offsets[i]] .. quads[offsets[i + 1] - 1]. */
typedef struct hexcon_loops {
  size_t count;           /**< of loops */
  size_t *offsets;        /**< [count + 1] into quads */
  int32_t *quads;         /**< [2 * quad_count]; every quad is passed twice */
  size_t *self_crossings; /**< [count] quads that the loop passes twice */
} hexcon_loops;

/**
 * Dual loops. Points are not needed: ids up to the largest used are taken to exist. Linear.
 * @param loops  filled; free with hexcon_loops_free. Errors: those of hexcon_check_surface.
 */
hexcon_status hexcon_surface_loops(hexcon_context *context, const int32_t *quads, size_t quad_count,
                                   hexcon_loops *loops);
void hexcon_loops_free(hexcon_context *context, hexcon_loops *loops);

/**
 * 2-colouring of the points along edges; the lowest id of each component is black (0). Linear.
 * @param colours  [point_count], receives 0 or 1. Errors: those of hexcon_check_surface except
 *                 UNUSED_POINT (unused points are black), and NOT_BIPARTITE.
 */
hexcon_status hexcon_surface_colouring(hexcon_context *context, const int32_t *quads,
                                       size_t quad_count, size_t point_count, uint8_t *colours);

/**
 * Pair every quad with a neighbour across an edge, so that each is in one pair. With points, pairs
 * are flat, of two like quads and not elongated, as far as can be: their total weight is close to
 * the greatest. A surface whose components are all even has such a pairing. Near-linear in
 * practice.
 * @param points      NULL: any pairing; then point_count only bounds the ids
 * @param pairs       [quad_count / 2][2] receives the quads, ascending in each pair and by the
 * first Errors: those of hexcon_check_surface (except UNUSED_POINT without points), ODD,
 * NO_PAIRING, CANCELLED.
 */
hexcon_status hexcon_surface_pairing(hexcon_context *context, const double *points,
                                     size_t point_count, const int32_t *quads, size_t quad_count,
                                     int32_t *pairs);

/**
 * Pair only what removes the self-crossings: after the paired transition of these pairs alone, two
 * hexes each, no loop of the surface crosses itself. As few pairs as a search finds, not always the
 * fewest; none where no loop crosses itself. The same for the same input. Of quads that share
 * several edges the pairs do not say which of these is meant. Time: some seconds from 150 quads on,
 * about a minute for 10^6, linear beyond.
 * @param pairs  [quad_count / 2][2] receives pair_count pairs, in hexcon_surface_pairing's order
 * @return errors: those of hexcon_check_surface except UNUSED_POINT; CANCELLED; where a loop
 *         crosses itself, ODD and NO_PAIRING
 */
hexcon_status hexcon_surface_pairing_of_crossings(hexcon_context *context, size_t point_count,
                                                  const int32_t *quads, size_t quad_count,
                                                  int32_t *pairs, size_t *pair_count);

/* ------------------------------------------------------------------------------------- verify */

/**
 * Verdict's scaled Jacobian: the minimum over the 8 corners of det(u, v, w) / (|u| |v| |w|).
 * @param scaled_jacobian  [hex_count], receives values in [-1, 1]; -1 for an edge of length 0.
 * Errors: EMPTY, TOO_LARGE, INDEX_OUT_OF_RANGE, NOT_FINITE. Linear.
 * Source: Knupp et al., The Verdict library reference manual (2006), section 5.
 */
hexcon_status hexcon_quality(hexcon_context *context, const double *points, size_t point_count,
                             const int32_t *hexes, size_t hex_count, double *scaled_jacobian);

/** How far hexcon_quality_second_order may be below the least value. */
#define HEXCON_CURVED_QUALITY_TOLERANCE 0.005

/**
 * The scaled Jacobian of hexes of order 2 as they are curved: a proved bound from below of
 * det(X_r, X_s, X_t) / (|X_r| |X_s| |X_t|) on the whole hex, within the tolerance above of its
 * least value (but for hexes that all but fold, where only the bound is sure). It is positive only
 * of hexes that are proved positive everywhere, as by hexcon_certify_second_order; of others it is
 * the least at 27 places, and at most 0.
 * @param hexes            [hex_count][20] VTK_QUADRATIC_HEXAHEDRON order
 * @param scaled_jacobian  [hex_count], receives values in [-1, 1]
 * Errors: as hexcon_quality, OUT_OF_MEMORY, CANCELLED. Linear: some ten microseconds a hex.
 */
hexcon_status hexcon_quality_second_order(hexcon_context *context, const double *points,
                                          size_t point_count, const int32_t *hexes,
                                          size_t hex_count, double *scaled_jacobian);

/** What is proved of a hex mesh. */
typedef struct hexcon_certificate {
  bool certified;  /**< conforming, proper, boundary_exact, embedded and every Jacobian positive:
                        then no two hexes overlap */
  bool conforming; /**< a 3-manifold: faces in at most 2 hexes, links are spheres or discs */
  bool proper;     /**< two hexes meet in nothing, one vertex, one edge or one face */
  bool boundary_exact; /**< the faces in one hex only are the given quads, outward */
  int64_t euler;       /**< points used - edges + faces - hexes */
  size_t nonpositive_count;
  int32_t *nonpositive; /**< hexes whose Jacobian is not proved positive, ascending */
  /**
   * [nonpositive_count][3] for each of them local coordinates (r, s, t) in [0, 1]^3 of a point of
   * the hex where the Jacobian is proved zero or negative, exact as they are: corner 0 of the hex
   * lies at (0, 0, 0), 1 at (1, 0, 0), 3 at (0, 1, 0), 4 at (0, 0, 1). NaN for the undecided.
   */
  double *witnesses;
  /** How many of them are not proved non-positive either: as far as can be told, their Jacobian
   * touches zero at a point that no doubles name, such as a third of an edge. */
  size_t undecided_count;
  size_t doublet_count;
  int32_t *doublets; /**< [doublet_count][2] hexes that share two or more faces */
  size_t improper_count;
  int32_t *improper; /**< hexes with a pair that meets improperly (at most one id a pair) */
  /** Of the boundary, and that no body lies in another; UNKNOWN where it is not exact. Its pairs
   * are rows of the given quads. */
  hexcon_embedding embedding;
} hexcon_certificate;

/**
 * Prove a hex mesh: topology by counting, Jacobians by Bernstein coefficients with subdivision, a
 * rigorous bound on rounding, and exact arithmetic where that bound leaves the sign open, and the
 * boundary embedded as hexcon_surface_embedding does. With these the mesh covers each place within
 * once and none without: where all Jacobians are positive every place is covered as often as the
 * boundary winds round it. Shares no code with the builder. Expected linear, whatever the
 * numbering, but for n log n in the boundary.
 * @param quads  [quad_count][4] the surface, outward
 * @param certificate  filled; free with hexcon_certificate_free
 * Errors: EMPTY, TOO_LARGE, INDEX_OUT_OF_RANGE, NOT_FINITE, REPEATED_VERTEX, OUT_OF_MEMORY,
 * CANCELLED. A mesh that fails is no error: the certificate says so.
 */
hexcon_status hexcon_certify(hexcon_context *context, const double *points, size_t point_count,
                             const int32_t *hexes, size_t hex_count, const int32_t *quads,
                             size_t quad_count, hexcon_certificate *certificate);

/**
 * Prove a mesh of order 2, of hexes with 20 nodes whose edges may be curved: as hexcon_certify, but
 * the Jacobians are those of the serendipity map, whose determinant has degree 5
 * in each direction; 216 Bernstein coefficients with subdivision bound them, as above. Hexes that
 * share an edge but not its middle node meet improperly, and so do those with a middle node that
 * another edge has, or that is a corner. `embedding` is that of the curved quads, each the patch of
 * its 8 nodes; of several shells the bilinear patches on the corners must be embedded as well, and
 * shells not meet on the way from these to the curved ones.
 * @param hexes  [hex_count][20] VTK_QUADRATIC_HEXAHEDRON order
 * @param quads  [quad_count][4] the corners of the surface, outward
 * Errors: as hexcon_certify. Cost: some ten microseconds a hex, more of those that are hardly
 * positive, and some a boundary quad.
 * Source: Johnen, Remacle, Geuzaine, Geometrical validity of curvilinear finite elements (2013);
 * the proof for curved quads is ours.
 */
hexcon_status hexcon_certify_second_order(hexcon_context *context, const double *points,
                                          size_t point_count, const int32_t *hexes,
                                          size_t hex_count, const int32_t *quads, size_t quad_count,
                                          hexcon_certificate *certificate);
void hexcon_certificate_free(hexcon_context *context, hexcon_certificate *certificate);

/* -------------------------------------------------------------------------------------- shape */

/** Options of hexcon_optimize; zero means default. */
typedef struct hexcon_optimize_options {
  int max_rounds; /**< passes over what is inverted, and then over what can be better; default 9 */
  int threads;    /**< default: one per processor. The result does not depend on it */
  double target;  /**< leave alone what reaches this scaled Jacobian; default 1 */
  /** Passes that raise the mean after that; default 0. For its sake a hex may be lowered to 3/4 of
   * the worst scaled Jacobian, but not below 0.1; where
   * the worst is below that already, by 0.2 % in a pass. */
  int mean_passes;
} hexcon_optimize_options;

/**
 * Untangle and improve a hex mesh by moving its free points. The result is never worse than the
 * start: first fewer inverted hexes, then a higher worst scaled Jacobian; the start is returned
 * where nothing better was found. Cost: linear in the hexes near bad ones, per iteration.
 * @param fixed      [point_count] non-zero: the point does not move
 * @param positions  [point_count][3] receives the result; may be `points` itself
 * @param options    NULL for defaults
 * Errors: as hexcon_quality, OUT_OF_MEMORY, CANCELLED (positions then hold the best so far).
 * Source: Garanzha et al., Foldover-free maps in 50 lines of code (2021).
 */
hexcon_status hexcon_optimize(hexcon_context *context, const double *points, size_t point_count,
                              const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                              const hexcon_optimize_options *options, double *positions);

/** Options of hexcon_morph; zero means default. */
typedef struct hexcon_morph_options {
  bool boundary_only; /**< only the fixed points' goals are given; the others' rows are ignored */
  double target;      /**< stop improving when the worst scaled Jacobian reaches it; default 1 */
} hexcon_morph_options;

/**
 * Homotopy: take a valid mesh from its boundary to another one of the same connectivity, step by
 * step; every state on the way is proved positive. Then raise the worst hex. Free points go along;
 * a step that cannot be untangled is halved.
 * @param points     [point_count][3] every hex positive
 * @param fixed      [point_count] non-zero: the point goes straight to its goal
 * @param goal       [point_count][3]; rows of free points are a first guess of where they go; free
 *                   points of no hex stay
 * @param options    NULL for defaults
 * @param positions  [point_count][3] receives the mesh at the end of the way: where the boundary
 *                   came to, its fixed points are at (1 - reached) points + reached goal
 * @param reached    receives the part of the way done: 1, bit for bit at the goal, or less where
 *                   no valid mesh was found farther on
 * Errors: as hexcon_quality, REPEATED_VERTEX, BAD_ARGUMENT, NOT_CERTIFIED (the start is not
 * positive), OUT_OF_MEMORY, CANCELLED (positions then hold the last valid state). Cost: that of
 * untangling the mesh as a whole, per step.
 */
hexcon_status hexcon_morph(hexcon_context *context, const double *points, size_t point_count,
                           const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                           const double *goal, const hexcon_morph_options *options,
                           double *positions, double *reached);

/* ------------------------------------------------------------------------------------- sliding */

/**
 * What a point of a boundary can slide on: name, in how many directions it moves there, and what
 * the fields of hexcon_carrier are for. New rows go to the end.
 */
#define HEXCON_CARRIERS(ROW)                                                                       \
  ROW(POINT, "point", 0, "origin: the point")                                                      \
  ROW(LINE, "line", 1,                                                                             \
      "origin on it, axis along it; sizes[0], unless 0: how far it goes from the origin on")       \
  ROW(CIRCLE, "circle", 1,                                                                         \
      "origin its centre, axis across its plane, sizes[0] its radius; sizes[1], unless 0: the "    \
      "angle "                                                                                     \
      "of an arc, from across on, right-handed about the axis")                                    \
  ROW(ELLIPSE, "ellipse", 1,                                                                       \
      "origin its centre, axis across its plane, across along its first half axis, sizes both "    \
      "half axes")                                                                                 \
  ROW(CURVE, "curve", 1, "any other curve: hexcon_project is asked")                               \
  ROW(PLANE, "plane", 2, "origin in it, axis its normal")                                          \
  ROW(CYLINDER, "cylinder", 2, "origin on its axis, axis along it, sizes[0] its radius")           \
  ROW(CONE, "cone", 2,                                                                             \
      "origin its apex, axis into the half that counts, sizes[0] its half angle in radians")       \
  ROW(SPHERE, "sphere", 2, "origin its centre, sizes[0] its radius")                               \
  ROW(TORUS, "torus", 2,                                                                           \
      "origin its centre, axis of revolution, sizes the radii of the ring and, no larger, of the " \
      "tube")                                                                                      \
  ROW(SURFACE, "surface", 2, "any other surface: hexcon_project is asked")                         \
  ROW(FACETS, "facets", 2, "its facets (see hexcon_sliding), curved by their normals")

#define HEXCON_CARRIER_VALUE(name, words, freedom, fields) HEXCON_CARRIER_##name,
typedef enum hexcon_carrier_kind {
  HEXCON_CARRIERS(HEXCON_CARRIER_VALUE) HEXCON_CARRIER_COUNT
} hexcon_carrier_kind;
#undef HEXCON_CARRIER_VALUE

/** A kind of carrier in words; static texts. */
typedef struct hexcon_carrier_facts {
  const char *name;
  int freedom; /**< directions in which a point moves on it: 0, 1 or 2 */
  const char *fields;
} hexcon_carrier_facts;

/** @return NULL for values that do not exist */
const hexcon_carrier_facts *hexcon_carrier_info(int kind);

/** A point, a curve or a surface; which fields count is told by its kind. Surfaces go on without
 * end: a plane is a whole plane; so do lines and circles that are given no end. */
typedef struct hexcon_carrier {
  int kind;         /**< a hexcon_carrier_kind */
  int32_t tag;      /**< what hexcon_project is told; any number */
  double origin[3]; /**< in the unit of the points */
  double axis[3];   /**< any length but 0 */
  double across[3]; /**< not along the axis */
  double sizes[2];  /**< radii > 0; lengths and angles of arcs >= 0; a half angle in 0 .. pi/2 */
} hexcon_carrier;

/**
 * Put points on curves and surfaces that have no closed form; called from the calling thread, for
 * many points at once.
 * @param points      [count][3]
 * @param tags        [count] which carrier each is to be put on
 * @param projected   [count][3] receives the nearest place on it
 * @param directions  [count][3] receives a tangent of the curve, or a normal of the surface, there;
 *                    of any length but 0, either way round
 * @return false to cancel
 */
typedef bool (*hexcon_project)(void *user, size_t count, const double *points, const int32_t *tags,
                               double *projected, double *directions);

/** carrier_of_point of a point that moves freely, and of one that stays where it is. */
enum { HEXCON_FREE = -1, HEXCON_STAYS = -2 };

/** What the points of a mesh slide on. A carrier is one piece or several, of which the nearest
 * counts, as the faces of a smooth patch: all points, all curves or all surfaces. As surfaces go on
 * without end, facets may tell where each piece counts: triangles near it, between its borders.
 * Then each piece of its carrier must have some, none may be a SURFACE, and the piece of the
 * nearest facet counts. */
typedef struct hexcon_sliding {
  const int32_t *carrier_of_point; /**< [point_count] in -2 .. carrier_count - 1 */
  size_t carrier_count;
  const int32_t *starts;        /**< [carrier_count + 1] into pieces, ascending, from 0 */
  const hexcon_carrier *pieces; /**< [starts[carrier_count]] */
  hexcon_project project;       /**< NULL if no piece is a CURVE or a SURFACE */
  void *project_user;
  size_t facet_point_count, facet_count; /**< 0: no facets */
  const double *facet_points;            /**< [facet_point_count][3] */
  const int32_t *facets;                 /**< [facet_count][3] into facet_points */
  const int32_t *piece_of_facet;         /**< [facet_count] into pieces */
  const double *facet_normals; /**< [facet_count][3][3] at corners, of any length but 0, either way
                                  round; NULL if no piece is of kind FACETS */
} hexcon_sliding;

/**
 * Put points on what they lie on: the nearest place on the nearest piece of their carrier.
 * @param positions   [point_count][3] receives them; may be `points` itself
 * @param directions  [point_count][3] receives unit tangents of curves and normals of surfaces, 0
 *                    of points that lie on neither; NULL: not wanted
 * Errors: those of hexcon_relax that tell of points and carriers. Linear.
 */
hexcon_status hexcon_project_points(hexcon_context *context, const double *points,
                                    size_t point_count, const hexcon_sliding *sliding,
                                    double *positions, double *directions);

/** Options of hexcon_relax; zero means default. */
typedef struct hexcon_relax_options {
  int max_rounds; /**< of untangling and evening; default 16 */
  /** Passes after that over what is inverted and over what can be better, as hexcon_optimize makes
   * them, while points slide; those on pieces that hexcon_project is asked for are held. Default 0:
   * none, nor any for the mean. */
  int passes;
  int mean_passes; /**< as of hexcon_optimize, after those */
  int threads;     /**< default: one per processor. The result does not depend on it */
  double budget; /**< seconds of wall time, after which the best so far is returned; 0: no limit */
} hexcon_relax_options;

/**
 * Untangle and smooth a hex mesh and its boundary together: points slide on what they lie on, and
 * are put back onto it, as near as rounding allows, after every step. From any start, also with
 * hexes of no volume. The start is put on its carriers first; the result is never worse than that:
 * fewer inverted hexes, by their corners, then (without mean_passes) a higher worst scaled
 * Jacobian. It does not depend on how points and hexes are numbered, as long as no two points lie
 * in one place.
 * @param sliding    what each point slides on
 * @param options    NULL for defaults
 * @param positions  [point_count][3] receives the result; may be `points` itself
 * Errors: as hexcon_quality, REPEATED_VERTEX, BAD_ARGUMENT (an option; or carriers, which are
 * listed; or what `project` answers), INDEX_OUT_OF_RANGE (points whose carrier does not exist),
 * OUT_OF_MEMORY, OUT_OF_TIME (before the start was on its carriers), CANCELLED (positions then hold
 * the best so far). Cost: linear in the hexes, some ten Newton steps.
 * Source: Garanzha et al., Foldover-free maps in 50 lines of code (2021), on products of manifolds
 * as in Absil, Mahony, Sepulchre, Optimization Algorithms on Matrix Manifolds (2008), section 6.
 */
hexcon_status hexcon_relax(hexcon_context *context, const double *points, size_t point_count,
                           const int32_t *hexes, size_t hex_count, const hexcon_sliding *sliding,
                           const hexcon_relax_options *options, double *positions);

/* -------------------------------------------------------------------------------------- solve */

/** A mesh of order 2: straight edges, each with a point in its middle. */
typedef struct hexcon_second_order {
  size_t point_count;
  double *points; /**< [point_count][3] the given points, then the middles */
  int32_t *hexes; /**< [hex_count][20] VTK_QUADRATIC_HEXAHEDRON order */
} hexcon_second_order;

/**
 * Put a point in the middle of every edge. Linear.
 * @param out  filled; free with hexcon_second_order_free
 * Errors: as hexcon_quality, OUT_OF_MEMORY.
 */
hexcon_status hexcon_raise_order(hexcon_context *context, const double *points, size_t point_count,
                                 const int32_t *hexes, size_t hex_count, hexcon_second_order *out);
void hexcon_second_order_free(hexcon_context *context, hexcon_second_order *raised);

/** The methods; hexcon_method_info tells what each is for. Saved macros hold the numbers: they stay
 * as they are, and a new method takes the next one. */
typedef enum hexcon_method {
  HEXCON_METHOD_AUTO = 0,
  HEXCON_METHOD_SWEPT = 1,
  HEXCON_METHOD_CELLS = 2,
  HEXCON_METHOD_DICED = 3,
  HEXCON_METHOD_SHEETS = 4,
  HEXCON_METHOD_SMALLEST = 5,
  HEXCON_METHOD_FOUR_SPLIT = 6,
  HEXCON_METHOD_PYRAMID = 7,
  HEXCON_METHOD_PYRAMID_ALT = 8,
  HEXCON_METHOD_GEODE = 9,
  HEXCON_METHOD_GEODE_ALT = 10,
  HEXCON_METHOD_PILLOWED = 11,
  HEXCON_METHOD_SHELLING = 12,
  HEXCON_METHOD_PROPOSAL = 13,
  HEXCON_METHOD_COUNT
} hexcon_method;

/** One try of `auto`. */
typedef struct hexcon_method_try {
  int turn;          /**< 1 comes first; 0: there is no such try */
  double good_worst; /**< scaled Jacobian, or nearly what the surface allows, with which nothing
                          after it is tried .. */
  size_t most_hexes; /**< .. if the mesh has so many hexes a quad at most; 0: any number */
  bool no_core;      /**< see hexcon_mesh_options */
} hexcon_method_try;

enum { HEXCON_METHOD_TRIES = 2 };

/** What a method is for, what it takes, and what is to be expected of it. Texts are static, never
 * NULL. Every method takes order, threads, budget and the like. */
typedef struct hexcon_method_facts {
  hexcon_method method;
  const char *name;    /**< as users write it, e.g. "pyramid-alt" */
  const char *label;   /**< in a list that people choose from */
  const char *purpose; /**< one line, without its full stop */
  /** How a mesh's report is told: {NAME} stands for the figure of that name, what is in [] is left
   * out where its figures are 0. */
  const char *told;
  bool topological;    /**< its meshes are conforming, but some Jacobians are zero or negative: no
                            solver must be given them, and auto never takes it */
  bool layers;         /**< takes hexcon_mesh_options.layers */
  bool core;           /**< heeds no_core */
  bool pairing;        /**< takes pairing and pairs */
  bool pillow;         /**< takes hexcon_mesh_options.pillow above 0 */
  bool tetrahedralise; /**< calls it, where there is one */
  bool proposal;       /**< takes proposal, and needs one, but for auto */
  bool holes;          /**< fills bodies with holes through them */
  bool cavities;       /**< fills bodies with cavities */
  bool odd_colours;    /**< takes points that cannot be coloured black and white along edges */
  bool odd_paths; /**< takes surfaces that bound no hex mesh (NO_HEX_MESH), as it fills no body */
  double
      hexes_a_quad; /**< to be expected for each quad; 0: it depends on the volume, not the quads */
  hexcon_method_try tries[HEXCON_METHOD_TRIES]; /**< of auto; a second one has other options */
} hexcon_method_facts;

/**
 * The methods in the order in which users are to see them.
 * @param row  from 0 on
 * @return static; NULL beyond the last row
 */
const hexcon_method_facts *hexcon_method_info(size_t row);

/** Which quads the topological methods pair, so that no dual loop crosses itself. */
typedef enum hexcon_pairing {
  HEXCON_PAIRING_ALL = 0, /**< every quad, as hexcon_surface_pairing without points of the surface
                               as numbered canonically */
  HEXCON_PAIRING_FEWEST,  /**< as hexcon_surface_pairing_of_crossings */
  HEXCON_PAIRING_NONE,    /**< for surfaces whose loops do not cross themselves anyway */
  HEXCON_PAIRING_GIVEN,   /**< the caller's pairs */
  HEXCON_PAIRING_COUNT
} hexcon_pairing;

/** Name of a pairing as users write it, e.g. "fewest"; NULL for values that do not exist. */
const char *hexcon_pairing_name(int pairing);

/** Tetrahedra that a hexcon_tetrahedralise callback hands out. */
typedef struct hexcon_tetrahedra {
  size_t point_count;   /**< of new points */
  const double *points; /**< [point_count][3] */
  size_t tetrahedron_count;
  const int32_t *tetrahedra; /**< [tetrahedron_count][4] ids of given points, then of new ones;
                                  (b - a, c - a, d - a) right-handed */
} hexcon_tetrahedra;

/**
 * Fills the inside of a closed triangulation with tetrahedra, whose boundary must be exactly the
 * given triangles; called from the thread that meshes.
 * @param points     [point_count][3] in an order that does not depend on the caller's numbering
 * @param triangles  [triangle_count][3] counter-clockwise seen from outside
 * @param out        arrays that stay valid until the next call, or until meshing returns
 * @return false if there are none: meshing goes on without
 */
typedef bool (*hexcon_tetrahedralise)(void *user, const double *points, size_t point_count,
                                      const int32_t *triangles, size_t triangle_count,
                                      hexcon_tetrahedra *out);

/** Hexes that whoever made a surface has in mind inside it. */
typedef struct hexcon_proposal {
  size_t hex_count;
  const int32_t
      *hexes;         /**< [hex_count][8] VTK order; ids of the surface's points, then of points */
  size_t point_count; /**< of inner points */
  const double *points; /**< [point_count][3] where they are at first; NULL: to be found */
} hexcon_proposal;

/** Values of hexcon_mesh_options.pillow besides numbers of sheets; and the largest of these. */
enum { HEXCON_PILLOW_AUTO = 0, HEXCON_PILLOW_NEVER = -1, HEXCON_PILLOW_MOST = 16 };

/** Options of hexcon_repair; zero means default. */
typedef struct hexcon_repair_options {
  int pillow;  /**< see hexcon_mesh_options */
  int threads; /**< default: one per processor. The result does not depend on it */
} hexcon_repair_options;

/** A repaired mesh: the given points and hexes in their order, then those of pillows. */
typedef struct hexcon_repaired {
  size_t point_count, hex_count;
  double *points; /**< [point_count][3] */
  int32_t *hexes; /**< [hex_count][8] */
  size_t pillows; /**< sheets laid */
} hexcon_repaired;

/**
 * Repair a hex mesh of any origin: move its free points as hexcon_optimize does, with passes for
 * the mean; then, where hexes are inverted or poor all the same, as where one has two faces of the
 * boundary in one plane, lay a sheet of hexes under the whole boundary and improve again. The
 * better of both is kept: fewer inverted hexes, then a clearly higher worst scaled Jacobian, then a
 * clearly higher mean, then fewer hexes. The boundary's faces stay what they are.
 * @param fixed    [point_count] non-zero: the point does not move; mostly those of the boundary
 * @param options  NULL for defaults
 * @param out      filled; free with hexcon_repaired_free
 * Errors: as hexcon_optimize, TOO_LARGE. Cost: as hexcon_optimize, twice.
 */
hexcon_status hexcon_repair(hexcon_context *context, const double *points, size_t point_count,
                            const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                            const hexcon_repair_options *options, hexcon_repaired *out);
void hexcon_repaired_free(hexcon_context *context, hexcon_repaired *repaired);

/** Options of hexcon_mesh_surface; zero means default. */
typedef struct hexcon_mesh_options {
  hexcon_method method;
  int order;              /**< 1 (default) or 2: mid-edge points, VTK_QUADRATIC_HEXAHEDRON order */
  bool allow_uncertified; /**< return the best mesh even if it is not certified */
  int threads;            /**< default: one per processor. The result does not depend on it */
  int layers;             /**< at least so many layers of plain hexes under the surface, before
                               anything else; which methods take them: hexcon_method_info */
  /** NULL for none; then all meets in one point, if one sees the whole surface */
  hexcon_tetrahedralise tetrahedralise;
  void *tetrahedralise_user;
  const hexcon_proposal *proposal; /**< NULL for none; auto tries it first */
  hexcon_pairing pairing;          /**< topological methods */
  const int32_t *pairs; /**< [pair_count][2] quads that share an edge, if pairing is GIVEN */
  size_t pair_count;
  bool skip_certificate; /**< prove nothing: the certificate is empty; topological methods leave the
                              quality out too. auto proves all the same */
  /** Seconds of wall time; 0: no limit. The call returns within them and 5 % more, or a second: the
   * time to measure and prove the mesh at hand is estimated from that taken to read the surface,
   * and kept back, so what is being done is given up that much earlier, and the best mesh until
   * then is taken. It is OUT_OF_TIME if there is none, or if it cannot be proved in that time. What
   * tetrahedralise takes is the caller's to limit. */
  double budget;
  bool allow_topological; /**< topological methods: take a surface that crosses or touches itself
                             too: its hexes overlap, as the certificate says */
  bool no_core;           /**< do not fill what layers leave, but refuse: NO_SHEETS */
  /** Sheets of hexes under the whole surface, as many hexes each as there are quads, laid as the
   * last step, and all improved then. HEXCON_PILLOW_AUTO: one where the worst hex is poor and it
   * makes it clearly better; HEXCON_PILLOW_NEVER; or so many, better or not. Topological methods
   * take none. */
  int pillow;
} hexcon_mesh_options;

/** Result of hexcon_mesh_surface. */
typedef struct hexcon_mesh hexcon_mesh;

/**
 * Fill a surface with hexes. The first point_count rows of the result are the input points.
 *
 * The same mesh, bit for bit, comes of a surface however its points, its quads and their corners
 * are numbered, by every method: the surface is numbered canonically at the entrance, points along
 * a Morton curve through their bounding box and then by (x, y, z), quads by their corners; ids come
 * back as the caller's, also those of errors. Where points coincide, they keep their order, and the
 * method may see another surface; and it is as independent of it as what tetrahedralise answers.
 * @param options  NULL for defaults
 * @param mesh     receives the result; free with hexcon_mesh_free
 * Errors: those of hexcon_check_surface, SELF_INTERSECTING, SEVERAL_COMPONENTS, ODD, NO_HEX_MESH
 * (all methods but four-split), NOT_BIPARTITE, BAD_PROPOSAL, NOT_SWEPT, UNFILLABLE_QUAD,
 * NOT_STAR_SHAPED, NO_SHEETS, NOT_DICED, NO_SMALL_FILLING, NO_ROTATIONS, NO_PAIRING, BAD_PAIRING,
 * SELF_CROSSING, NO_SIDES, NOT_A_BALL, NOT_CERTIFIED, CANCELLED, OUT_OF_TIME, BAD_ARGUMENT,
 * OUT_OF_MEMORY; `mesh` is then NULL. A topological mesh that is conforming and has the surface for
 * its boundary is no error. Cost: linear in the hexes made, plus the optimisation of what is bad.
 */
hexcon_status hexcon_mesh_surface(hexcon_context *context, const double *points, size_t point_count,
                                  const int32_t *quads, size_t quad_count,
                                  const hexcon_mesh_options *options, hexcon_mesh **mesh);
void hexcon_mesh_free(hexcon_context *context, hexcon_mesh *mesh);

size_t hexcon_mesh_point_count(const hexcon_mesh *mesh);
size_t hexcon_mesh_hex_count(const hexcon_mesh *mesh);
int hexcon_mesh_order(const hexcon_mesh *mesh);
/** [point_count][3] */
const double *hexcon_mesh_points(const hexcon_mesh *mesh);
/** [hex_count][8], or [hex_count][20] at order 2 */
const int32_t *hexcon_mesh_hexes(const hexcon_mesh *mesh);
/** [hexcon_mesh_quad_count][4] the input quads in their order, outward (turned if they were
 * inward); method four-split: and then its inner quads */
const int32_t *hexcon_mesh_quads(const hexcon_mesh *mesh);
size_t hexcon_mesh_quad_count(const hexcon_mesh *mesh);
/** True if the method's meshes are topological: never certified, for no solver. */
bool hexcon_mesh_is_topological(const hexcon_mesh *mesh);
/** False if skip_certificate was set: hexcon_mesh_certificate tells nothing. */
bool hexcon_mesh_is_checked(const hexcon_mesh *mesh);
/** Name of the method that made it, static text */
const char *hexcon_mesh_method(const hexcon_mesh *mesh);
const hexcon_certificate *hexcon_mesh_certificate(const hexcon_mesh *mesh);
/** Scaled Jacobian of every hex [hex_count]; NULL where it was left out */
const double *hexcon_mesh_quality(const hexcon_mesh *mesh);

/** A figure of the report: counts, seconds per stage ("seconds <stage>"), quality. "hexes of
 * <stage>" tell the stages that put hexes in, which lie one after the other, from outside to
 * inside. */
typedef struct hexcon_figure {
  char name[48];
  double value;
} hexcon_figure;
/** The stages that put hexes in; where there are several of one kind, a number follows its name:
 * "hexes of split layer 2". @param row from 0 on @return NULL beyond the last */
const hexcon_stage_facts *hexcon_hex_stage(size_t row);
/** @param figures receives the array @return its length */
size_t hexcon_mesh_report(const hexcon_mesh *mesh, const hexcon_figure **figures);
/** What was tried, in order, a line each; valid as long as the mesh. */
const char *hexcon_mesh_log(const hexcon_mesh *mesh);

#ifdef HEXCON_SHARED
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
