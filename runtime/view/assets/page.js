(() => {
  "use strict";

  const data = JSON.parse(document.getElementById("data").textContent);
  const count = data.values.length;
  const last = count - 1;
  const [start, end] = [data.values[0], data.values[last]];
  const root = document.documentElement;

  // Columns: differences as variable-length quantities in base 64.
  const DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const digit = Object.fromEntries([...DIGITS].map((letter, value) => [letter, value]));
  function decoded(text) {
    const values = [];
    let [value, quantity, shift] = [0, 0, 0];
    for (const letter of text) {
      quantity += (digit[letter] & 31) << shift;
      shift += 5;
      if (digit[letter] < 32) {
        value += quantity & 1 ? -(quantity >>> 1) : quantity >>> 1;
        values.push(value);
        [quantity, shift] = [0, 0];
      }
    }
    return values;
  }
  const columns = data.columns.map(decoded);
  const orders = data.orders.map(decoded);
  const order = decoded(data.order);

  // Elements of the drawing.
  function made(tag, attributes) {
    const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
    Object.entries(attributes).forEach(([name, value]) => node.setAttribute(name, value));
    return node;
  }
  const moving = [];
  const nodes = data.elements.map(({ tag, at, title, text, ...rest }) => {
    const node = made(tag, rest.class ? { class: rest.class } : {});
    if (title) {
      node.append(made("title", {}));
      node.firstChild.textContent = title;
    }
    if (text) node.append(text);
    for (const [name, parts] of Object.entries(at)) {
      if (Array.isArray(parts)) moving.push({ node, name, parts, value: "" });
      else node.setAttribute(name, parts);
    }
    return node;
  });
  const marks = document.getElementById("marks");
  let painted = -1;
  function draw(state) {
    for (const one of moving) {
      let value = "";
      for (const part of one.parts) value += typeof part === "number" ? columns[part][state] / 10 : part;
      if (value !== one.value) one.node.setAttribute(one.name, (one.value = value));
    }
    if (order[state] !== painted) {
      painted = order[state];
      marks.replaceChildren(...orders[painted].map((element) => nodes[element]));
    }
  }

  // Traces: the whole way faintly, what has passed plainly, and the point.
  const ways = document.getElementById("traces");
  const traces = data.traces.map(([x, y], number) => {
    const whole = ways.children[number];
    whole.classList.add("whole");
    const passed = whole.cloneNode();
    passed.setAttribute("class", "trace passed");
    const spot = made("circle", { class: "spot", r: 3.2, style: whole.getAttribute("style") });
    const lengths = [0];
    for (let i = 1; i < count; i++) {
      const step = Math.hypot(columns[x][i] - columns[x][i - 1], columns[y][i] - columns[y][i - 1]) / 10;
      lengths.push(lengths[i - 1] + step);
    }
    return { x: columns[x], y: columns[y], passed, spot, lengths };
  });
  traces.forEach(({ passed }) => ways.append(passed));
  const spots = made("g", {});
  spots.append(...traces.map(({ spot }) => spot));
  marks.after(spots);
  function trace(state) {
    for (const { x, y, passed, spot, lengths } of traces) {
      passed.setAttribute("stroke-dasharray", `${lengths[state].toFixed(1)} ${lengths[last] + 9}`);
      passed.style.display = state ? "" : "none";
      spot.setAttribute("cx", x[state] / 10);
      spot.setAttribute("cy", y[state] / 10);
    }
  }

  // Numbers.
  function format(values, digits) {
    const size = Math.max(...values.map((value) => Math.abs(value ?? 0)));
    const places = digits - 1 - Math.floor(Math.log10(size || 1));
    const isPlain = places >= 0 && places <= 7;
    const isLong = places < 0 && places > -4;
    const write = (value) => (isPlain || isLong ? value.toFixed(Math.max(places, 0)) : value.toExponential(digits - 1));
    return (value) => (value == null ? "–" : write(value).replaceAll("-", "−"));
  }
  function ticks(self, values) {
    const size = Math.max(...values.map(Math.abs));
    const isPlain = size === 0 || (size < 1e6 && size >= 1e-3);
    const write = (value) => (isPlain || value === 0 ? String(value) : value.toExponential());
    return values.map((value) => write(Number(value.toPrecision(8))).replaceAll("-", "−"));
  }
  const step = (end - start) / Math.max(last, 1);
  const spread = Math.max(Math.abs(start), Math.abs(end)) || 1;
  const moment = format(data.values, Math.min(9, Math.max(3, 2 + Math.ceil(Math.log10(spread / (step || spread))))));
  const unit = (name) => (name ? ` ${name}` : "");
  const axis = (name, of) => (of ? `${name} in ${of}` : name);

  // Diagrams.
  let shown = -1;
  const section = document.getElementById("plots");
  const computed = (name) => {
    const probe = document.createElement("i");
    probe.style.color = `var(${name})`;
    root.append(probe);
    const colour = getComputedStyle(probe).color;
    probe.remove();
    return colour;
  };
  let inks = {};
  const theme = () => (inks = { ink: computed("--main-color"), faint: computed("--faint") });
  theme();
  // Paper is not measured before it is printed on; this fits.
  const PAPER = 640;
  let printing = false;
  const width = () => (printing ? PAPER : Math.max(section.clientWidth, 120));
  const height = () => Math.round(Math.min(260, Math.max(150, (innerHeight * 0.72) / data.plots.length - 40)));
  // States at which circles are at least so many pixels apart.
  const APART = 14;
  function apart(plot, values) {
    let [left, top] = [-Infinity, -Infinity];
    return values.flatMap((value, state) => {
      if (value == null) return [];
      const [x, y] = [plot.valToPos(data.values[state], "x"), plot.valToPos(value, "y")];
      if (Math.hypot(x - left, y - top) < APART) return [];
      [left, top] = [x, y];
      return [state];
    });
  }
  let hue = data.traces.length;
  const point = (plot) => plot.setCursor({ left: plot.valToPos(data.values[shown], "x"), top: 1 }, false);
  const plots = data.plots.map((plot) => {
    const figure = document.createElement("figure");
    figure.setAttribute("role", "group");
    figure.setAttribute("aria-label", plot.series.map(({ name }) => axis(name, plot.unit)).join(", "));
    section.append(figure);
    const thin = { stroke: () => inks.faint, width: 1 };
    const font = "12px system-ui, sans-serif";
    const line = { stroke: () => inks.ink, grid: thin, ticks: { ...thin, size: 4 }, font, labelFont: font, labelSize: 18, values: ticks };
    const none = () => null;
    const series = plot.series.map(({ name, values, isDotted }) => {
      const write = format(values, 5);
      const value = (self, number) => write(number) + (number == null ? "" : unit(plot.unit));
      if (isDotted) {
        const points = { show: true, size: 6, width: 1.2, fill: "transparent", filter: (self) => apart(self, values) };
        return { label: name, stroke: () => inks.ink, paths: none, points, value };
      }
      const stroke = data.colours[hue++ % data.colours.length];
      return { label: name, stroke, width: 1.6, pxAlign: 0, points: { show: count < 40 }, value };
    });
    return new uPlot(
      {
        width: width(),
        height: height(),
        scales: { x: { time: false } },
        axes: [
          { ...line, label: axis(data.name, data.unit), size: 30, labelGap: 0 },
          { ...line, label: plot.unit, size: 52, labelGap: 2 },
        ],
        hooks: { draw: [(self) => shown >= 0 && point(self)] },
        series: [{ label: data.name, value: (self, number) => (number == null ? "–" : moment(number) + unit(data.unit)) }, ...series],
        cursor: {
          y: false,
          drag: { x: false, y: false, setScale: false },
          dataIdx: () => shown,
          points: { size: 8 },
          bind: { mousedown: none, mouseup: none, mousemove: none, mouseenter: none, mouseleave: none, click: none, dblclick: none },
        },
      },
      [data.values, ...plot.series.map(({ values }) => values)],
      figure,
    );
  });
  for (const plot of plots) {
    // The pointer takes the motion along.
    const drag = (event) => {
      const box = plot.over.getBoundingClientRect();
      pause();
      seek(nearest(plot.posToVal(event.clientX - box.left, "x")));
    };
    plot.over.addEventListener("pointerdown", (event) => {
      plot.over.setPointerCapture(event.pointerId);
      drag(event);
    });
    plot.over.addEventListener("pointermove", (event) => event.buttons && drag(event));
  }
  const resize = () => plots.forEach((plot) => plot.setSize({ width: width(), height: height() }));

  // Controls.
  const ICONS = {
    play: '<path d="M3 1.5v13l11-6.5z"/>',
    pause: '<path d="M3 1.5h3.6v13H3zM9.4 1.5H13v13H9.4z"/>',
    theme: '<path d="M8 0a8 8 0 1 0 0 16A8 8 0 0 0 8 0zm0 2v12A6 6 0 0 1 8 2z"/>',
  };
  const icon = (name) => `<svg viewBox="0 0 16 16" aria-hidden="true">${ICONS[name]}</svg>`;
  const controls = document.createElement("div");
  controls.className = "controls";
  controls.setAttribute("role", "group");
  controls.setAttribute("aria-label", "Playback");
  controls.innerHTML =
    `<button id="play" type="button"></button><input id="moment" type="range" min="0" max="${last}" step="1">` +
    '<output id="readout" for="moment" aria-live="off"></output><label>speed <select id="speed"></select></label>' +
    '<p class="keys"><kbd>space</kbd> play or pause · <kbd>←</kbd> <kbd>→</kbd> one state, with <kbd>shift</kbd> ten · ' +
    "<kbd>home</kbd> <kbd>end</kbd> · <kbd>+</kbd> <kbd>−</kbd> speed</p>";
  document.querySelector("main").after(controls);
  const paper = document.createElement("p");
  paper.className = "shown";
  document.querySelector("header").append(paper);
  const [play, scrub, readout, speeds] = ["play", "moment", "readout", "speed"].map((id) => document.getElementById(id));
  scrub.setAttribute("aria-label", axis(data.name, data.unit));
  const toggle = document.createElement("button");
  toggle.type = "button";
  toggle.id = "theme";
  toggle.innerHTML = icon("theme");
  toggle.setAttribute("aria-label", "Light or dark");
  document.querySelector("header").append(toggle);

  const factors = [-4, -3, -2, -1, 0, 1, 2, 3].flatMap((power) => [1, 2, 5].map((digit) => Number(`${digit}e${power}`)));
  if (!factors.includes(data.speed)) factors.push(data.speed);
  factors.sort((one, two) => one - two);
  // What nobody could watch is not offered.
  const offered = factors.filter((factor) => factor === data.speed || (data.lasting / factor < 1000 && data.lasting / factor > 0.2));
  for (const factor of offered) speeds.add(new Option(`×${Number(factor.toPrecision(3))}`, factor, false, factor === data.speed));
  speeds.title = data.isTime ? "as a part of real time" : "";

  // Playing.
  let playing = false;
  let at = start;
  let before = 0;
  function nearest(value) {
    let [low, high] = [0, last];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (data.values[middle] <= value) low = middle;
      else high = middle;
    }
    return value - data.values[low] <= data.values[high] - value ? low : high;
  }
  function show(state) {
    if (state === shown) return;
    shown = state;
    draw(state);
    trace(state);
    plots.forEach(point);
    const text = `${data.name} = ${moment(data.values[state])}${unit(data.unit)}`;
    scrub.value = state;
    scrub.setAttribute("aria-valuetext", text);
    readout.textContent = paper.textContent = text;
    root.dataset.state = state;
  }
  function seek(state) {
    const to = Math.min(last, Math.max(0, state));
    at = data.values[to];
    show(to);
  }
  function tick(now) {
    if (!playing) return;
    const passed = Math.min(0.25, Math.max(0, (now - before) / 1000));
    before = now;
    at += (passed * Number(speeds.value) * (end - start)) / data.lasting;
    if (at > end) at = start + ((at - end) % (end - start || 1));
    show(nearest(at));
    requestAnimationFrame(tick);
  }
  function label() {
    play.innerHTML = icon(playing ? "pause" : "play");
    play.setAttribute("aria-label", playing ? "Pause" : "Play");
    readout.setAttribute("aria-live", playing ? "off" : "polite");
  }
  function pause() {
    playing = false;
    label();
  }
  function resume() {
    if (playing || count < 2) return;
    playing = true;
    label();
    requestAnimationFrame((now) => {
      before = now;
      tick(now);
    });
  }
  const toggled = () => (playing ? pause() : resume());
  const move = (by) => {
    pause();
    seek(shown + by);
  };
  const faster = (by) => {
    speeds.selectedIndex = Math.min(speeds.length - 1, Math.max(0, speeds.selectedIndex + by));
  };

  play.addEventListener("click", toggled);
  scrub.addEventListener("input", () => {
    pause();
    seek(Number(scrub.value));
  });
  const KEYS = {
    " ": toggled,
    ArrowLeft: (event) => move(event.shiftKey ? -10 : -1),
    ArrowRight: (event) => move(event.shiftKey ? 10 : 1),
    Home: () => move(-count),
    End: () => move(count),
    "+": () => faster(1),
    "=": () => faster(1),
    "-": () => faster(-1),
    "−": () => faster(-1),
  };
  document.addEventListener("keydown", (event) => {
    const { target, key } = event;
    // Buttons and lists know their own keys.
    const isOwn = (target.closest("button, summary") && key === " ") || (target.closest("select") && !"+-=−".includes(key));
    if (event.ctrlKey || event.metaKey || event.altKey || isOwn || !Object.hasOwn(KEYS, key)) return;
    event.preventDefault();
    KEYS[key](event);
  });

  // Light and dark.
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const recolour = () => {
    theme();
    plots.forEach((plot) => plot.redraw(false));
  };
  toggle.addEventListener("click", () => {
    const isDark = (root.dataset.theme ?? (dark.matches ? "dark" : "light")) === "dark";
    root.dataset.theme = isDark ? "light" : "dark";
    recolour();
  });
  dark.addEventListener("change", recolour);
  matchMedia("print").addEventListener("change", recolour);

  seek(0);
  new ResizeObserver(resize).observe(section);
  addEventListener("resize", resize);
  for (const [event, begins] of [["beforeprint", true], ["afterprint", false]]) {
    addEventListener(event, () => {
      printing = begins;
      resize();
    });
  }
  label();
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) resume();
})();
