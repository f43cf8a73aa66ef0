/*
 * A display controller and its glass in software: fed with the bytes of the wires, it says what the eye would see, and what no data sheet allows.
 *
 * It knows nothing of fixcast: no bus, no panel record, only data sheets (sections named in virtual_mipi.c and virtual_ssd.c). Time is virtual and
 * moves by virtual_time() alone, so that the time which bytes take does not hide a missing delay.
 *
 *   static virtual_panel panel;
 *   virtual_open(&panel, &virtual_st7789_240);
 *   virtual_clock(&panel, 10000000, 0);
 *   virtual_reset(&panel, true); virtual_time(&panel, 10); virtual_reset(&panel, false); virtual_time(&panel, 5000);
 *   virtual_feed(&panel, false, 0x01); ...
 *   virtual_finish(&panel);
 *   if (panel.errors != 0) puts(panel.error); else colour = virtual_shown(&panel, x, y);
 */
#ifndef FIXCAST_TEST_VIRTUAL_PANEL_H
#define FIXCAST_TEST_VIRTUAL_PANEL_H

#include <stdbool.h>
#include <stdint.h>

typedef struct virtual_panel virtual_panel;

/* The commands first..last take `count` parameters, or are followed by pixels. */
enum {
  VIRTUAL_PIXELS = 255,
  VIRTUAL_PARAMETERS_MAX = 64,
  VIRTUAL_MEMORY_MAX = 240 * 320 /* pixels; 480 * 128 is less */
};
typedef struct virtual_command {
  uint8_t first, last, count;
} virtual_command;

/* How one family of controllers understands bytes. */
typedef struct virtual_family {
  bool parameters_as_commands; /* with D/C low */
  bool pixels_without_command; /* D/C high is always pixels */
  void (*reset)(virtual_panel *panel);
  void (*execute)(virtual_panel *panel, uint8_t command, const uint8_t *parameters); /* all parameters have come */
  void (*pixel_byte)(virtual_panel *panel, uint8_t byte);
  uint32_t (*shown)(const virtual_panel *panel, uint16_t x, uint16_t y);
} virtual_family;

/* A controller with its glass. */
typedef struct virtual_model {
  const char *name;
  const virtual_family *family;
  const virtual_command *commands;      /* ends with a count of VIRTUAL_PIXELS and first > last */
  uint16_t memory_width, memory_height; /* pixels */
  uint16_t width, height;               /* of the glass */
  uint16_t glass_x, glass_y;            /* memory column and row of the glass's corner, counted from the mirrored side if mirrored */
  bool mirror_x, mirror_y;              /* the glass is mounted the other way */
  bool bgr;                             /* its colour filter is blue, green, red */
  bool inverted;                        /* it needs inversion to be on */
  bool twelve_bits;                     /* it takes 12 bits a pixel */
  uint32_t hz_max;                      /* serial write clock; 10 MHz at most until the display is on */
  uint32_t reset_low_us, reset_wait_us; /* least time of reset, and from there to the first command */
  uint32_t sleep_in_us;                 /* from sleep in to the next command */
} virtual_model;

struct virtual_panel {
  const virtual_model *model;
  /* the verdict */
  unsigned errors;
  char error[240]; /* the first one, a sentence */
  /* what has come */
  unsigned long windows, pixels, commands; /* windows opened, pixels written, commands */
  /* wires */
  uint64_t now_us, reset_since_us, ready_at_us, wake_at_us, settled_at_us;
  uint32_t hz;
  uint8_t spi_mode;
  bool in_reset;
  /* the command that is coming in */
  bool command_open; /* a command has come, and parameters or pixels may follow */
  uint8_t command, wanted, got;
  uint8_t parameters[VIRTUAL_PARAMETERS_MAX];
  /* registers */
  bool awake, on, invert, all_on, all_off, unlocked, pump, rows_reversed;
  uint8_t direction, direction2, depth, addressing, offset, start_line, mux, common_pins;
  uint16_t x0, x1, y0, y1, x, y; /* window and write position, in the controller's units */
  bool window_full;
  uint8_t part[3], parts;              /* bytes of a pixel that is not complete */
  uint32_t memory[VIRTUAL_MEMORY_MAX]; /* 0xRRGGBB as the eye would see it if not inverted */
};

extern const virtual_model virtual_st7789_240, virtual_st7789_135, virtual_st7789_320, virtual_st7789_170, virtual_ili9341, virtual_st7735_128,
    virtual_ssd1351, virtual_ssd0323, virtual_ssd1327, virtual_ssd1322, virtual_ssd1306;

/* The model of that name, or NULL. */
const virtual_model *virtual_model_named(const char *name);

/* Power on: memory holds noise, nothing is configured. */
void virtual_open(virtual_panel *panel, const virtual_model *model);
void virtual_time(virtual_panel *panel, uint32_t us);                    /* that much time passes */
void virtual_clock(virtual_panel *panel, uint32_t hz, uint8_t spi_mode); /* of the bytes to come */
void virtual_reset(virtual_panel *panel, bool active);
void virtual_feed(virtual_panel *panel, bool data, uint8_t byte); /* one byte; `data`: D/C is high as its last bit comes */
/* The stream is over: complains about what is incomplete. */
void virtual_finish(virtual_panel *panel);
/* What the eye sees at (x, y) of the glass held the right way up: 0xRRGGBB, black while the display is off. */
uint32_t virtual_shown(const virtual_panel *panel, uint16_t x, uint16_t y);

/* For the families: */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void
virtual_complain(virtual_panel *panel, const char *format, ...);
void virtual_window(virtual_panel *panel);       /* x0..y1 are set: checks them and opens the window */
void virtual_next(virtual_panel *panel);         /* the write position moves on, right, then down */
bool virtual_writable(virtual_panel *panel);     /* whether a pixel may be written now; complains if not */
void virtual_whole_pixels(virtual_panel *panel); /* complains when bytes of a pixel are missing, and forgets them */

#endif
