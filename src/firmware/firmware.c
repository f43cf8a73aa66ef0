#include "firmware.h"

#include "controls.h"
#include "crc32.h"
#include "fixcast/fixcast.h"
#include "orbit.h"
#include "pattern.h"
#include "queue.h"
#include "s1.h"
#include "text.h"

#ifdef FC_FIRMWARE_CRC
#define WITH_CRC true
#else
#define WITH_CRC false
#endif

#define REPORT_US UINT32_C(1000000) /* of showing frames between lines of figures */
/* The orbit goes round the middle of S1's largest sphere. Round the middle of all three the light would at times be the farthest thing from the
 * eye, where the core has no fast form for it. */
#define AXIS_X FC_Q16(0)
#define AXIS_Z FC_Q16(-6)

/* Frames since the last line of figures. */
typedef struct tally {
  uint32_t began_us, render; /* render: cycles, or microseconds where the board has no cycle counter */
  uint16_t frames;
} tally;

typedef struct run {
  const fc_firmware_board *board;
  fc_text out;
  fc_panel_state panel;
  fc_display display;
  fc_display_capabilities capabilities;
  fc_area place;      /* of the picture */
  uint16_t send_rows; /* rows sent at a time: strip_rows, or a page of FC_DISPLAY_MONO8 */
  size_t send_pitch;
  uint8_t *pixels; /* where strips are drawn; NULL: in the buffer that is sent */
  uint8_t *send[FC_QUEUE_STRIPS];
  uint16_t *depth;
  void *frame_memory;
  fc_scratch *scratch; /* what strips are drawn in */
  size_t frame_bytes;
  uint8_t buffers, turn; /* how many of `send` there are, which one is free */
  fc_queue queue;        /* of more than two */
  fc_frame frame;
  fc_controls controls;
  tally tally;
  uint32_t crc, shown;
} run;

static uint32_t clock_us(const run *self) { return self->board->microseconds(self->board->context); }

static uint32_t clock_render(const run *self) {
  return self->board->cycles != NULL ? self->board->cycles(self->board->context) : clock_us(self);
}

/* ---- text ---- */

static void say_format(const run *self) {
  static const char names[4][8] FC_ROM = {" rgb565", " rgb444", " grey4", " mono"};
  fc_text_rom(&self->out, names[self->capabilities.format & 3]);
}

/* Of the picture's rows, from a multiple of 8 where the format has pages. */
static uint32_t bytes_of_rows(const run *self, uint16_t rows) {
  return (uint32_t)self->send_pitch * (self->capabilities.format == FC_DISPLAY_MONO8 ? rows / 8u : rows);
}

static uint32_t bytes_of_frame(const run *self) { return bytes_of_rows(self, self->place.height); }

static uint32_t wire_hz(const run *self) {
  const fc_bus *bus = &self->board->bus;
  return bus->ops->clock_hz(bus->context);
}

static void say_start(const run *self) {
  const fc_firmware_board *board = self->board;
  const fc_text *out = &self->out;
  const uint32_t hz = wire_hz(self), bytes = bytes_of_frame(self);
  fc_panel panel;
  FC_READ(&panel, board->panel, sizeof panel);
  fc_text_rom(out, FC_TEXT("fixcast on "));
  fc_text_rom(out, board->name);
  fc_text_rom(out, FC_TEXT(", "));
  fc_text_unsigned(out, board->cpu_hz);
  fc_text_rom(out, FC_TEXT(" Hz\npanel "));
  fc_text_rom(out, panel.name);
  fc_text_rom(out, FC_TEXT(" "));
  fc_text_unsigned(out, self->place.width);
  fc_text_rom(out, FC_TEXT("x"));
  fc_text_unsigned(out, self->place.height);
  say_format(self);
  fc_text_rom(out, FC_TEXT(", spi requested "));
  fc_text_unsigned(out, board->options.pixel_hz != 0 ? board->options.pixel_hz : panel.pixel_hz);
  fc_text_rom(out, FC_TEXT(" Hz, actual "));
  fc_text_unsigned(out, hz);
  fc_text_rom(out, FC_TEXT(" Hz\nwire limit "));
  fc_text_tenths(out, hz / 8u * 10u / bytes);
  fc_text_rom(out, FC_TEXT(" fps, "));
  fc_text_unsigned(out, bytes);
  fc_text_rom(out, FC_TEXT(" bytes a frame\n"));
}

static void say_crc(const run *self) {
  if (!WITH_CRC) return;
  fc_text_rom(&self->out, FC_TEXT(" crc "));
  fc_text_hex(&self->out, self->crc);
}

/* The figures of the tally, which then starts again. */
static void say_figures(run *self, uint32_t now_us) {
  const fc_firmware_board *board = self->board;
  const fc_text *out = &self->out;
  const uint32_t frames = self->tally.frames, pixels = (uint32_t)self->place.width * self->place.height;
  const uint32_t mhz = board->cpu_hz / UINT32_C(1000000), ms = (now_us - self->tally.began_us) / 1000u;
  const uint32_t render = self->tally.render / frames; /* a frame's */
  const uint32_t render_us = board->cycles != NULL ? render / mhz : render;
  const uint32_t cycles = board->cycles != NULL ? render : render * mhz;
  const uint32_t khz = wire_hz(self) / 1000u, wire_us = khz != 0 ? bytes_of_frame(self) * 8000u / khz : 0;
  fc_text_unsigned(out, frames);
  fc_text_rom(out, FC_TEXT(" frames: "));
  fc_text_tenths(out, frames * 10000u / (ms != 0 ? ms : 1u));
  fc_text_rom(out, FC_TEXT(" fps, render "));
  fc_text_unsigned(out, render_us);
  fc_text_rom(out, FC_TEXT(" us, "));
  fc_text_unsigned(out, cycles / pixels);
  fc_text_rom(out, FC_TEXT(" cycles a pixel, wire "));
  fc_text_unsigned(out, wire_us);
  fc_text_rom(out, FC_TEXT(" us a frame: "));
  if (self->capabilities.asynchronous == 0) {
    fc_text_rom(out, FC_TEXT("one after the other"));
  } else {
    fc_text_rom(out, wire_us > render_us ? FC_TEXT("wire binds") : FC_TEXT("render binds"));
  }
  if (board->ram_bytes != NULL) {
    fc_text_rom(out, FC_TEXT(", ram "));
    fc_text_unsigned(out, board->ram_bytes(board->context));
    fc_text_rom(out, FC_TEXT(" bytes"));
  }
  fc_text_rom(out, FC_TEXT("\n"));
  self->tally.frames = 0;
  self->tally.render = 0;
  self->tally.began_us = now_us;
}

/* ---- memory and place ---- */

/* The picture in the middle of the panel, to the panel's alignment. */
static int find_place(run *self) {
  const fc_firmware_board *board = self->board;
  const fc_display_capabilities *panel = &self->capabilities;
  fc_area *place = &self->place;
  place->width = board->width != 0 ? board->width : panel->width;
  place->height = board->height != 0 ? board->height : panel->height;
  if (place->width > panel->width || place->height > panel->height) return FC_ERR_SIZE;
  if (place->width % panel->x_align != 0 || place->height % panel->y_align != 0) return FC_ERR_AREA;
  place->x = (uint16_t)((panel->width - place->width) / 2 / panel->x_align * panel->x_align);
  place->y = (uint16_t)((panel->height - place->height) / 2 / panel->y_align * panel->y_align);
  return FC_OK;
}

static void *take(uint8_t **free, size_t *left, size_t bytes) {
  uint8_t *taken = *free;
  bytes = (bytes + 7u) & ~(size_t)7u;
  if (bytes > *left) return NULL;
  *free += bytes;
  *left -= bytes;
  return taken;
}

static int share_memory(run *self) {
  const fc_firmware_board *board = self->board;
  const uint8_t format = self->capabilities.format;
  const size_t drawn = (size_t)self->place.width * 2u * board->strip_rows;
  uint8_t *free = board->memory;
  size_t left = board->memory_bytes, sent;
  uint16_t lines;
  uint8_t i;
  bool all = true;
  int error;
  self->buffers = board->buffers != 0 ? board->buffers : 2;
  if (board->strip_rows == 0 || self->buffers < 2 || self->buffers > FC_QUEUE_STRIPS) return FC_ERR_SIZE;
  self->send_rows = board->strip_rows;
  if (format == FC_DISPLAY_MONO8 && board->strip_rows < 8) self->send_rows = 8;
  if (format == FC_DISPLAY_MONO8 && self->send_rows % (board->strip_rows < 8 ? board->strip_rows : 8) != 0) return FC_ERR_AREA;
  self->send_pitch = fc_display_row_bytes(format, self->place.width);
  lines = format == FC_DISPLAY_MONO8 ? self->send_rows / 8 : self->send_rows;
  sent = self->send_pitch * lines;
  self->frame_bytes = fc_frame_memory(&s1, &error);
  if (self->frame_bytes == 0) return error;
  self->frame_memory = take(&free, &left, self->frame_bytes);
  self->scratch = take(&free, &left, sizeof *self->scratch);
  self->depth = take(&free, &left, drawn);
  /* Pixels that don't shrink much are changed where they are. */
  if (format == FC_DISPLAY_GREY4 || format == FC_DISPLAY_MONO8) {
    self->pixels = take(&free, &left, drawn);
    if (self->pixels == NULL) return FC_ERR_MEMORY;
  } else {
    sent = drawn;
  }
  for (i = 0; i < self->buffers; i++) {
    self->send[i] = take(&free, &left, sent);
    if (self->send[i] == NULL) all = false;
  }
  return self->frame_memory == NULL || self->scratch == NULL || self->depth == NULL || !all ? FC_ERR_MEMORY : FC_OK;
}

/* ---- drawing ---- */

/* Draws rows of the picture, from its row y, into a strip. */
typedef int fill(run *self, uint16_t y, uint16_t rows, uint8_t *pixels);

static int fill_pattern(run *self, uint16_t y, uint16_t rows, uint8_t *pixels) {
  fc_pattern_rows(self->place.width, self->place.height, y, rows, pixels);
  return FC_OK;
}

static int fill_black(run *self, uint16_t y, uint16_t rows, uint8_t *pixels) {
  (void)y;
  memset(pixels, 0, (size_t)self->place.width * 2u * rows);
  return FC_OK;
}

static int fill_scene(run *self, uint16_t y, uint16_t rows, uint8_t *pixels) {
  const fc_firmware_board *board = self->board;
  fc_target target = {0};
  target.pixels = pixels;
  target.pitch_bytes = (size_t)self->place.width * 2u;
  target.format = FC_RGB565_BE;
  target.depth = self->depth;
  return board->render != NULL ? board->render(board->context, self->scratch, &self->frame, y, rows, &target)
                               : fc_render_rows_in(self->scratch, &self->frame, y, rows, &target);
}

/* A strip in the panel's format; `y` and `area` are on the panel. Pages are made row by row where strips are lower. */
static int convert(const run *self, const fc_area *area, uint16_t y, uint16_t rows, const uint8_t *pixels, uint8_t *to) {
  const uint8_t format = self->capabilities.format;
  const size_t pitch = (size_t)area->width * 2u;
  int error = FC_OK;
  if (format == FC_DISPLAY_RGB565) return FC_OK;
  if (format != FC_DISPLAY_MONO8 || rows % 8 == 0) {
    return fc_display_convert(format, area->x, y, area->width, rows, pixels, pitch, to, self->send_pitch);
  }
  for (; rows > 0 && error == FC_OK; rows--, y++, pixels += pitch) {
    error = fc_display_convert(format, area->x, y, area->width, 1, pixels, pitch, to, self->send_pitch);
  }
  return error;
}

/* Sends a strip, or adds it to those that wait; returns when the next buffer is free. */
static int send_strip(run *self, const fc_area *area) {
  uint8_t *pixels = self->send[self->turn];
  self->turn = (uint8_t)((self->turn + 1u) % self->buffers);
  if (self->buffers == 2) return fc_display_write_start(&self->display, area, pixels, self->send_pitch, NULL, NULL);
  fc_queue_add(&self->queue, area, pixels, self->send_pitch);
  return fc_queue_wait(&self->queue, (uint8_t)(self->buffers - 1u));
}

/* Until all is on the panel. */
static int settle(run *self) {
  const int error = self->buffers == 2 ? FC_OK : fc_queue_wait(&self->queue, 0);
  return error < 0 ? error : fc_display_wait(&self->display);
}

/* Draws and sends a picture of the usual size at `place`; its last strips may still be on their way. */
static int draw(run *self, const fc_area *place, fill *draw_rows) {
  const uint16_t strips = (uint16_t)((place->height + self->send_rows - 1u) / self->send_rows), upper = (uint16_t)(strips - strips / 2);
  uint32_t crc[2] = {0, 0}; /* of the rows from the top, and of those from strip `upper` on where the halves alternate */
  uint16_t i, part;
  for (i = 0; i < strips; i++) {
    const uint8_t lower = self->board->alternate ? i % 2 : 0;
    const uint16_t strip = self->board->alternate ? (uint16_t)(i / 2 + (lower ? upper : 0)) : i;
    const uint16_t y = (uint16_t)(strip * self->send_rows), left = (uint16_t)(place->height - y);
    const fc_area area = {place->x, (uint16_t)(place->y + y), place->width, left < self->send_rows ? left : self->send_rows};
    uint8_t *send = self->send[self->turn], *pixels = self->pixels != NULL ? self->pixels : send;
    const uint32_t began = clock_render(self);
    uint16_t rows;
    int error;
    for (part = 0; part < area.height; part = (uint16_t)(part + rows)) {
      rows = (uint16_t)(area.height - part);
      if (rows > self->board->strip_rows) rows = self->board->strip_rows;
      error = draw_rows(self, (uint16_t)(y + part), rows, pixels);
      if (error >= 0) error = convert(self, &area, (uint16_t)(area.y + part), rows, pixels, send);
      if (error < 0) return error;
    }
    self->tally.render += clock_render(self) - began;
    if (WITH_CRC) crc[lower] = fc_crc32(crc[lower], send, bytes_of_rows(self, area.height));
    error = send_strip(self, &area);
    if (error < 0) return error;
  }
  self->crc = crc[0];
  if (WITH_CRC && self->board->alternate && strips > 1) {
    self->crc = fc_crc32_join(crc[0], crc[1], bytes_of_rows(self, (uint16_t)(place->height - upper * (uint32_t)self->send_rows)));
  }
  return FC_OK;
}

/* Makes what is round a small picture black. */
static int clear(run *self) {
  const fc_display_capabilities *panel = &self->capabilities;
  fc_area tile = self->place;
  if (tile.width == panel->width && tile.height == panel->height) return FC_OK;
  for (tile.y = 0;;) {
    for (tile.x = 0;;) {
      const int error = draw(self, &tile, fill_black);
      if (error < 0) return error;
      if (tile.x + tile.width >= panel->width) break;
      tile.x = (uint16_t)(tile.x + tile.width < panel->width - tile.width ? tile.x + tile.width : panel->width - tile.width);
    }
    if (tile.y + tile.height >= panel->height) break;
    tile.y = (uint16_t)(tile.y + tile.height < panel->height - tile.height ? tile.y + tile.height : panel->height - tile.height);
  }
  return FC_OK;
}

static int show_pattern(run *self) {
  int error = draw(self, &self->place, fill_pattern);
  if (error >= 0) error = settle(self);
  if (error < 0) return error;
  fc_text_rom(&self->out, FC_TEXT("pattern shown"));
  say_crc(self);
  fc_text_rom(&self->out, FC_TEXT("\n"));
  fc_firmware_frame_shown();
  return FC_OK;
}

/* ---- frames ---- */

#ifdef __GNUC__
__attribute__((noinline))
#endif
void
fc_firmware_frame_shown(void) {
#ifdef __GNUC__
  __asm__ volatile("" ::
                       : "memory"); /* so that the call stays */
#endif
}

/* Brings the scene into the camera's space of this step, while the last strip of the frame before leaves. */
static int prepare(run *self) {
  const uint32_t began = clock_render(self);
  fc_camera camera;
  int error;
  fc_orbit(&s1_camera, AXIS_X, AXIS_Z, self->controls.step, &camera);
  error = fc_frame_setup(&self->frame, &s1, &camera, NULL, self->place.width, self->place.height, self->frame_memory,
                         self->frame_bytes);
  self->tally.render += clock_render(self) - began;
  return error;
}

/* Waits until the frame that was drawn is on the panel, and says so. */
static int finish(run *self) {
  uint32_t now_us;
  const int error = settle(self);
  if (error < 0) return error;
  if (WITH_CRC) {
    fc_text_rom(&self->out, FC_TEXT("frame "));
    fc_text_unsigned(&self->out, self->shown);
    say_crc(self);
    fc_text_rom(&self->out, FC_TEXT("\n"));
  }
  fc_firmware_frame_shown();
  self->shown++;
  self->tally.frames++;
  now_us = clock_us(self);
  if (now_us - self->tally.began_us >= REPORT_US || self->shown == self->board->frames) say_figures(self, now_us);
  return FC_OK;
}

static void read_buttons(run *self) {
  const fc_firmware_board *board = self->board;
  if (board->buttons != NULL) fc_controls_buttons(&self->controls, board->buttons(board->context));
}

static int show_frames(run *self) {
  const uint16_t frames = self->board->frames;
  bool drawn = false;
  int error = FC_OK;
  fc_controls_start(&self->controls);
  self->tally.render = 0;
  self->tally.began_us = clock_us(self);
  while (error >= 0) {
    const bool last = drawn && frames != 0 && self->shown + 1u == frames;
    read_buttons(self);
    if (drawn) fc_controls_advance(&self->controls);
    if (!last) error = prepare(self);
    if (error >= 0 && drawn) error = finish(self);
    if (last) break;
    drawn = false;
    if (error >= 0 && self->controls.pattern) {
      error = show_pattern(self);
    } else if (error >= 0) {
      error = draw(self, &self->place, fill_scene);
      drawn = true;
    }
  }
  return error;
}

static int start(run *self) {
  const fc_firmware_board *board = self->board;
  uint32_t began_us;
  int error;
  if (board->microseconds == NULL || board->panel == NULL || board->memory == NULL) return FC_ERR_NULL;
  error = fc_panel_start(&self->panel, board->panel, &board->bus, &board->options, &self->display);
  if (error < 0) return error;
  fc_display_capabilities_get(&self->display, &self->capabilities);
  fc_queue_start(&self->queue, &self->display);
  error = find_place(self);
  if (error >= 0) error = share_memory(self);
  if (error < 0) return error;
  say_start(self);
  error = clear(self);
  if (error >= 0) error = show_pattern(self);
  if (error < 0) return error;
  if (self->capabilities.has_backlight) error = fc_display_backlight(&self->display, 255);
  began_us = clock_us(self);
  while (clock_us(self) - began_us < board->pattern_ms * UINT32_C(1000)) {
  }
  return error;
}

int fc_firmware_run(const fc_firmware_board *board) {
  run self = {0};
  int error;
  if (board == NULL || board->put == NULL) return FC_ERR_NULL;
  self.board = board;
  self.out.put = board->put;
  self.out.context = board->context;
  error = start(&self);
  if (error >= 0) error = show_frames(&self);
  if (error < 0) {
    fc_text_rom(&self.out, FC_TEXT("error: "));
    fc_text_ram(&self.out, fc_error_text(error));
    fc_text_rom(&self.out, FC_TEXT(" ("));
    fc_text_signed(&self.out, error);
    fc_text_rom(&self.out, FC_TEXT(")\n"));
    return error;
  }
  fc_text_rom(&self.out, FC_TEXT("done\n"));
  return FC_OK;
}
