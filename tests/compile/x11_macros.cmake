# SPDX-License-Identifier: MIT
#
# The macros of X11's headers (Xlib.h, Xutil.h, Xatom.h, keysym.h, Xresource.h, XKBstr.h) that are plain words. Python.h
# has no such: its own all begin with Py.
set(x11_macros
    Above AllHints AllPlanes AllTemporary AllValues AllocAll AllocNone AllowExposures AlreadyGrabbed Always
    AnyButton AnyKey AnyModifier AnyPropertyType ArcChord ArcPieSlice AsyncBoth AsyncKeyboard AsyncPointer
    AutoRepeatModeDefault AutoRepeatModeOff AutoRepeatModeOn BadAccess BadAlloc BadAtom BadColor BadCursor
    BadDrawable BadFont BadGC BadIDChoice BadImplementation BadLength BadMatch BadName BadPixmap BadRequest BadValue
    BadWindow Below BitmapBitOrder BitmapFileInvalid BitmapNoMemory BitmapOpenFailed BitmapPad BitmapSuccess
    BitmapUnit BlackPixel Bool BottomIf ButtonPress ButtonRelease CapButt CapNotLast CapProjecting CapRound
    CirculateRequest ClientMessage ClipByChildren ColormapInstalled ColormapUninstalled Complex ConfigureRequest
    ConnectionNumber ControlMapIndex Convex CoordModeOrigin CoordModePrevious CopyFromParent CurrentTime CursorShape
    DefaultBlanking DefaultColormap DefaultDepth DefaultExposures DefaultGC DefaultRootWindow DefaultScreen
    DefaultScreenOfDisplay DefaultVisual DestroyAll DirectColor DisableAccess DisableScreenInterval
    DisableScreenSaver DisplayCells DisplayHeight DisplayHeightMM DisplayPlanes DisplayString DisplayWidth
    DisplayWidthMM DoBlue DoGreen DoRed DoesBackingStore DoesSaveUnders DontAllowExposures DontCareState
    DontPreferBlanking EnableAccess EvenOddRule Expose False FillOpaqueStippled FillSolid FillStippled FillTiled
    FirstExtensionError FocusIn FocusOut FontChange FontLeftToRight FontRightToLeft GenericEvent GrabFrozen
    GrabInvalidTime GrabModeAsync GrabModeSync GrabNotViewable GrabSuccess GraphicsExpose GrayScale HeightValue
    HostDelete HostInsert IconicState ImageByteOrder InactiveState IncludeInferiors InputFocus InputOnly InputOutput
    IsCursorKey IsFunctionKey IsKeypadKey IsMiscFunctionKey IsModifierKey IsPFKey IsPrivateKeypadKey IsUnmapped
    IsUnviewable IsViewable JoinBevel JoinMiter JoinRound KeyPress KeyRelease LASTEvent LSBFirst LastExtensionError
    LastKnownRequestProcessed LedModeOff LedModeOn LineDoubleDash LineOnOffDash LineSolid LockMapIndex LowerHighest
    MSBFirst MapRequest MappingBusy MappingFailed MappingKeyboard MappingModifier MappingPointer MappingSuccess
    NeedFunctionPrototypes NeedNestedPrototypes NeedVarargsPrototypes NeedWidePrototypes NextRequest NoExpose
    NoSymbol NoValue Nonconvex None NormalState NotUseful NotifyAncestor NotifyDetailNone NotifyGrab NotifyInferior
    NotifyNonlinear NotifyNonlinearVirtual NotifyNormal NotifyPointer NotifyPointerRoot NotifyUngrab NotifyVirtual
    NotifyWhileGrabbed Opposite PAllHints PAspect PBaseSize PMaxSize PMinSize PResizeInc PSize ParentRelative
    PlaceOnBottom PlaceOnTop PointerRoot PointerWindow PreferBlanking PropModeAppend PropModePrepend PropModeReplace
    PropertyDelete PropertyNewValue ProtocolRevision ProtocolVersion PseudoColor QLength QueuedAfterFlush
    QueuedAfterReading QueuedAlready RaiseLowest RectangleIn RectangleOut RectanglePart ReleaseByFreeingColormap
    ReplayKeyboard ReplayPointer ResizeRequest RetainPermanent RetainTemporary RevertToNone RevertToParent
    RevertToPointerRoot RootWindow ScreenCount ScreenOfDisplay ScreenSaverActive ScreenSaverReset SelectionClear
    SelectionRequest ServerVendor SetModeDelete SetModeInsert ShiftMapIndex StaticColor StaticGray Status
    StippleShape Success SyncBoth SyncKeyboard SyncPointer TileShape TopIf True TrueColor Unsorted VendorRelease
    VisibilityFullyObscured VisibilityPartiallyObscured VisibilityUnobscured WhenMapped WhitePixel WidthValue
    WindingRule WithdrawnState XAddPixel XAllocID XBufferOverflow XConverterNotFound XDestroyImage XGetPixel
    XLocaleNotSupported XLookupBoth XLookupChars XLookupKeySym XLookupNone XPutPixel XStringToContext XSubImage
    XUniqueContext XValue XYBitmap XYPixmap XlibSpecificationRelease YNegative YSorted YValue YXBanded YXSorted
    ZPixmap ZoomState)
