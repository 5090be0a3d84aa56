/* SPDX-License-Identifier: LGPL-2.1-or-later */
/*
 * Fill the surface of a box with hexes, prove the mesh, and say what is wrong with a box that has a
 * hole. Build it against the installed library:
 *
 *   cc fill_surface.c $(pkg-config --cflags --libs hexcon) -o fill_surface
 *
 * or with the CMakeLists.txt beside this file.
 */
#include <hexcon.h>
#include <stdio.h>
#include <string.h>

enum { SIDE = 4, ROW = SIDE + 1, POINTS = 6 * SIDE * SIDE + 2, QUADS = 6 * SIDE * SIDE };

/** The surface of a box of SIDE x SIDE x SIDE cubes, each quad counter-clockwise seen from outside.
 */
typedef struct box_surface {
  double points[POINTS][3];
  int32_t quads[QUADS][4];
  int32_t id_of[ROW][ROW][ROW]; /* id + 1 of the point at a place of the grid; 0: it has none yet */
  int32_t point_count, quad_count;
} box_surface;

static int32_t point_at(box_surface *box, const int at[3]) {
  int32_t *id = &box->id_of[at[0]][at[1]][at[2]];
  if (*id == 0) {
    for (int axis = 0; axis < 3; axis++)
      box->points[box->point_count][axis] = at[axis];
    *id = ++box->point_count;
  }
  return *id - 1;
}

/** One quad of the side where the coordinate `axis` is 0 or SIDE; (i, j) is its lowest corner
 * there. */
static void add_quad(box_surface *box, int axis, int end, int i, int j) {
  static const int corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  int32_t *quad = box->quads[box->quad_count++];
  for (int corner = 0; corner < 4; corner++) {
    int at[3];
    at[axis] = end;
    at[(axis + 1) % 3] = i + corners[corner][0];
    at[(axis + 2) % 3] = j + corners[corner][1];
    quad[end ? corner : 3 - corner] = point_at(box, at);
  }
}

static void make_box(box_surface *box) {
  memset(box, 0, sizeof *box);
  for (int axis = 0; axis < 3; axis++)
    for (int end = 0; end <= SIDE; end += SIDE)
      for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++)
          add_quad(box, axis, end, i, j);
}

/** The words, the code and the ids of what went wrong. */
static void tell_fault(const hexcon_context *context, hexcon_status status) {
  const int32_t *ids;
  size_t count = hexcon_context_elements(context, &ids);
  printf("%s: %s\n", hexcon_status_name(status), hexcon_context_message(context));
  for (size_t i = 0; i < count; i++)
    printf("%s%d", i ? ", " : "  listed: ", (int)ids[i]);
  printf("%s  to do: %s\n", count ? "\n" : "", hexcon_status_info(status)->advice);
}

static void tell_mesh(const hexcon_mesh *mesh) {
  const hexcon_certificate *proof = hexcon_mesh_certificate(mesh);
  const double *quality = hexcon_mesh_quality(mesh);
  size_t hexes = hexcon_mesh_hex_count(mesh);
  double worst = 1;
  for (size_t hex = 0; hex < hexes; hex++)
    worst = quality[hex] < worst ? quality[hex] : worst;
  printf("method %s: %zu hexes, %zu points\n", hexcon_mesh_method(mesh), hexes,
         hexcon_mesh_point_count(mesh));
  printf("certified: %s; worst scaled Jacobian %.3f\n", proof->certified ? "yes" : "no", worst);
}

static bool show_stage(void *user, const char *stage, double fraction) {
  size_t *calls = user;
  (void)stage, (void)fraction;
  ++*calls;
  return true; /* false would cancel */
}

int main(void) {
  static box_surface box;
  size_t calls = 0;
  hexcon_mesh *mesh;
  hexcon_context *context = hexcon_context_new();
  if (!context)
    return 1;
  make_box(&box);
  printf("HexCon %s\n", hexcon_version());
  hexcon_context_set_progress(context, show_stage, &calls);
  hexcon_mesh_options options = {.method = HEXCON_METHOD_AUTO, .budget = 60};
  hexcon_status status =
      hexcon_mesh_surface(context, &box.points[0][0], (size_t)box.point_count, &box.quads[0][0],
                          (size_t)box.quad_count, &options, &mesh);
  if (status) {
    tell_fault(context, status);
    hexcon_context_free(context);
    return 1;
  }
  tell_mesh(mesh);
  printf("progress was told: %s\n", calls ? "yes" : "no");
  hexcon_mesh_free(context, mesh);

  printf("without its last quad:\n");
  status = hexcon_mesh_surface(context, &box.points[0][0], (size_t)box.point_count,
                               &box.quads[0][0], (size_t)box.quad_count - 1, NULL, &mesh);
  if (status)
    tell_fault(context, status);
  hexcon_context_free(context);
  return status ? 0 : 1;
}
