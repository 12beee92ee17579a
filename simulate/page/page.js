// SPDX-License-Identifier: GPL-3.0-or-later
// The time, and what moves it: the play button, the slider, keys, plots, and `#t=` in the address.
"use strict";

(() => {
  const byId = id => document.getElementById(id);
  const recording = decodeRecording(JSON.parse(byId("data").textContent));
  const {t: times, pressure} = recording.frames;

  let begin = times[0], end = times[times.length - 1];
  for (const {t} of recording.series) {
    if (t.length === 0) continue;
    begin = Math.min(begin, t[0]);
    end = Math.max(end, t[t.length - 1]);
  }
  // Series are rounded to floats: their first and last instants are those of frames, where that is all the difference.
  if (Math.fround(times[0]) === begin) begin = times[0];
  if (Math.fround(times[times.length - 1]) === end) end = times[times.length - 1];

  let now = begin, frame = -1, isPlaying = false;
  const scene = makeScene(recording, byId("view"), byId("panel"));
  const plots = makePlots(recording.series, byId("plots"), begin, end, t => moveTo(t));
  document.body.classList.toggle("no-plots", plots.isEmpty);

  // Pressures
  const sortedPressures = Float32Array.from(pressure).sort();
  const kLimits = {
    run: () => sortedPressures[sortedPressures.length - 1],
    most: () => sortedPressures[Math.floor(0.99 * (sortedPressures.length - 1))],
    now: () => {
      let greatest = 0;
      forEachElement(recording, frame, (surface, face, p) => { greatest = Math.max(greatest, p); });
      return greatest;
    },
  };
  byId("bar").style.background = `linear-gradient(to top, ${
    kColourStops.map(stop => `rgb(${stop.map(c => Math.round(255 * c)).join(",")})`).join(",")})`;
  const drawTicks = limit => {
    const power = prefixPower(limit, "Pa");
    const scale = 1000 ** power;
    const ticks = roundTicks(0, 0.9 * limit / scale, 4);
    const tick = (x, label) => {
      const made = element("span", {textContent: label});
      made.style.bottom = 100 * x * scale / limit + "%";
      return made;
    };
    byId("ticks").replaceChildren(
      ...[...ticks, limit / scale].map(x => tick(x, `${threeDigits(x)} ${kPrefixes[power]}Pa`)));
  };

  // Forces
  let greatestForce = 0;
  const forceOf = i => Math.hypot(...recording.frames.contact.subarray(6 * i + 3, 6 * i + 6));
  for (let i = 0; i < recording.frames.contact_pairing.length; ++i) greatestForce = Math.max(greatestForce, forceOf(i));
  // In the middle of the slider the greatest force is a fifth of the scene long.
  const metresPerNewton = () =>
    greatestForce > 0 && scene ? 10 ** Number(byId("arrow-scale").value) * scene.size / 5 / greatestForce : 0;
  const showContacts = () => {
    const {firstContact, contact, contact_pairing} = recording.frames;
    const forces = new Map();
    for (let i = firstContact[frame]; i < firstContact[frame + 1]; ++i) {
      const sum = forces.get(contact_pairing[i]) || [0, 0, 0];
      forces.set(contact_pairing[i], sum.map((f, k) => f + contact[6 * i + 3 + k]));
    }
    const rows = [...forces].map(([pairing, force]) => [recording.pairings[pairing].name, Math.hypot(...force)]);
    rows.sort((a, b) => b[1] - a[1]);
    byId("contacts").replaceChildren(...rows.map(([name, force]) => element("tr", {},
      element("td", {textContent: name}), element("td", {textContent: quantity(force, "N")}))));
    if (rows.length === 0)
      byId("contacts").append(element("tr", {}, element("td", {className: "none", textContent: "no contact"})));
  };

  const showFrame = () => {
    if (!scene) return;
    const limit = kLimits[byId("colour-range").value]() || 0;
    drawTicks(limit > 0 ? limit : 1);
    scene.show(frame, limit > 0 ? limit : 1, metresPerNewton());
    showContacts();
    byId("arrow-unit").textContent = greatestForce > 0 ? `longest ${quantity(greatestForce, "N")}` : "";
  };
  const showTime = () => {
    const next = nearest(times, now);
    if (next !== frame) {
      frame = next;
      showFrame();
    }
    plots.showTime(now);
    byId("slider").value = now;
    byId("time").textContent = `${now.toFixed(digits)}\u00a0s \u00b7 frame ${frame + 1} of ${times.length}`;
    window.pcmTime = now;
  };
  const digits = Math.max(2, Math.min(9, Math.ceil(-Math.log10((end - begin || 1) / 2000))));
  const moveTo = t => {
    now = Math.max(begin, Math.min(end, t));
    showTime();
  };

  // Playing
  let last;
  const tick = stamp => {
    if (!isPlaying) return;
    // Where the page was hidden for long, it goes on from where it was.
    const passed = last === undefined ? 0 : Math.min(1, (stamp - last) / 1000);
    moveTo(now + passed * Number(byId("speed").value));
    last = stamp;
    if (now >= end) setPlaying(false); else requestAnimationFrame(tick);
  };
  const setPlaying = on => {
    if (on === isPlaying) return;
    isPlaying = on;
    byId("play").textContent = on ? "Pause" : "Play";
    if (!on) return;
    if (now >= end) moveTo(begin);
    last = undefined;
    requestAnimationFrame(tick);
  };
  const step = frames => {
    setPlaying(false);
    moveTo(times[Math.max(0, Math.min(times.length - 1, frame + frames))]);
  };

  byId("play").addEventListener("click", () => setPlaying(!isPlaying));
  Object.assign(byId("slider"), {min: begin, max: end});
  byId("slider").addEventListener("input", event => moveTo(Number(event.target.value)));
  // An option is chosen, and the arrow keys are the time's again.
  document.querySelectorAll("select").forEach(select => select.addEventListener("change", () => select.blur()));
  const kKeys = {
    ArrowLeft: shift => step(shift ? -10 : -1),
    ArrowRight: shift => step(shift ? 10 : 1),
    Home: () => step(-times.length),
    End: () => step(times.length),
    " ": () => setPlaying(!isPlaying),
  };
  document.addEventListener("keydown", event => {
    const key = Object.hasOwn(kKeys, event.key) && !event.ctrlKey && !event.altKey && !event.metaKey;
    // What has the focus and knows the key itself keeps it.
    const {target} = event;
    const isElsewhere = target.id !== "slider" && target.matches("select, input[type=range]");
    const isPressed = event.key === " " && target.matches("button, input[type=checkbox], summary");
    if (!key || isElsewhere || isPressed) return;
    event.preventDefault();
    kKeys[event.key](event.shiftKey);
  });
  const readAddress = () => {
    const found = /^#t=([-+.0-9eE]+)$/.exec(location.hash);
    if (!found || !isFinite(Number(found[1]))) return;
    setPlaying(false);
    moveTo(Number(found[1]));
  };
  window.addEventListener("hashchange", readAddress);

  // What is shown
  const triangles = recording.surfaces.reduce((sum, {faces}) => sum + faces.length / 3, 0);
  byId("summary").textContent = `${quantity(begin, "")} to ${quantity(end, "")} s, ${times.length} frames, ${
    recording.surfaces.length} surfaces, ${triangles.toLocaleString("en")} triangles`;
  byId("surfaces").firstElementChild.textContent = `Surfaces (${recording.surfaces.length})`;
  recording.surfaces.forEach((surface, i) => {
    const box = element("input", {type: "checkbox", checked: true});
    const swatch = element("span", {className: "swatch"});
    swatch.style.background = `rgb(${surface.colour.join(",")})`;
    byId("surfaces").append(element("label", {}, box, swatch, surface.name));
    box.addEventListener("change", () => {
      if (scene) scene.surfaces[i].visible = box.checked;
      showFrame();
    });
  });
  byId("pressure").hidden = pressure.length === 0;
  byId("forces").hidden = recording.pairings.length === 0;
  byId("colour-range").addEventListener("change", showFrame);
  byId("arrow-scale").addEventListener("input", showFrame);
  byId("through").addEventListener("change", event => {
    if (scene) scene.elements.seeThrough(event.target.checked);
    showFrame();
  });
  byId("cameras").addEventListener("click", event => {
    const {view} = event.target.dataset;
    if (!view || !scene) return;
    scene.aim(view, frame);
    showFrame();
  });

  const resize = () => {
    if (scene) scene.resize();
    plots.draw();
    if (frame >= 0) showFrame();
    showTime();
  };
  if (!scene) {
    document.body.classList.add("no-scene");
    byId("no-scene").hidden = false;
    byId("no-scene").textContent =
      "This browser shows no WebGL, which the scene in 3D needs (it may be switched off, or the graphics driver may be " +
      "missing). The plots do without.";
    byId("cameras").hidden = byId("panel").hidden = true;
  }
  new ResizeObserver(resize).observe(document.body);
  resize();
  readAddress();
  window.pcmProject = point => (scene ? scene.project(point) : null);
  window.pcmArrowLength = metresPerNewton;
  window.pcmReady = true;
})();
