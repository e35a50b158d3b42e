// Shows the drawing of the plane that the page carries: a drag moves it, the wheel makes it larger.
(function () {
  "use strict";
  const data = JSON.parse(document.getElementById("scene").textContent);
  const picture = document.getElementById("picture");
  const start = picture.getAttribute("viewBox").split(" ").map(Number);
  let view = start.slice(); // x, y, width, height

  function show() {
    picture.setAttribute("viewBox", view.join(" "));
  }
  function move(right, down) {
    view = [view[0] + right, view[1] + down, view[2], view[3]];
    show();
  }
  // The place of an event in the drawing's own pixels.
  function placeOf(event) {
    return new DOMPoint(event.clientX, event.clientY).matrixTransform(picture.getScreenCTM().inverse());
  }
  function zoom(factor, about) {
    const most = start[2] * 4, least = start[2] / 1000;
    const width = Math.min(most, Math.max(least, view[2] / factor));
    const share = 1 - width / view[2];
    const fixed = about || {x: view[0] + view[2] / 2, y: view[1] + view[3] / 2};
    view = [view[0] + share * (fixed.x - view[0]), view[1] + share * (fixed.y - view[1]),
            width, view[3] * width / view[2]];
    show();
  }
  function changed() {
    picture.querySelectorAll("[data-layer]").forEach(function (mark) {
      mark.style.display = panel.isOn(mark.dataset.layer, mark.dataset.light) ? "" : "none";
    });
  }

  let held = null; // where the drag has hold of the drawing
  picture.addEventListener("pointerdown", function (event) {
    if (event.button !== 0) return;
    held = placeOf(event);
    picture.setPointerCapture(event.pointerId);
  });
  picture.addEventListener("pointermove", function (event) {
    if (!held) return;
    const now = placeOf(event);
    move(held.x - now.x, held.y - now.y);
  });
  ["pointerup", "pointercancel"].forEach(function (end) {
    picture.addEventListener(end, function () { held = null; });
  });
  picture.addEventListener("wheel", function (event) {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY / 500), placeOf(event));
  }, {passive: false});

  const step = start[2] / 40;
  const panel = gnomonPanel(data, {
    changed: changed,
    reset: function () { view = start.slice(); show(); },
    turn: function (right, up) { move(right * step, -up * step); },
    zoom: zoom
  });
  changed();
  document.documentElement.setAttribute("data-drawn", "yes");
})();
